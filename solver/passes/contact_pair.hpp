#pragma once

#include <cstddef>
#include <cstdint>

#include "core/pack.hpp"
#include "passes/gathered.hpp"
#include "passes/kernel_pair.hpp"

namespace tektite {

/// What contact needs of a particle.
template <int D>
struct ContactRecord {
  Vector<double, D> x;      ///< m, in the middle of a step
  double volume;            ///< of the reference configuration, so that the potential depends on places alone
  double bulk_modulus;      ///< Pa
  double smoothing_length;  ///< m
  double spacing;           ///< Δp, m

  void mirror(int axis, double at) { x[axis] = 2.0 * at - x[axis]; }
};

/// The potential of pairs of different bodies, φ = V_a V_b K_ca (W_ab/W(Δp))^n with K_ca = factor · (smaller bulk
/// modulus)/Δp^D: Young et al. (2021), eq. 15.
template <class Kernel, int D>
struct ContactPotential {
  const ContactRecord<D>* records;
  double factor;
  int exponent;  ///< n, at least 2

  struct Self {
    std::size_t index;
    Vector<Pack, D> x;
    Pack volume, bulk_modulus, h, spacing;
  };
  struct Pair {
    Pack energy;            ///< φ, J
    Vector<Pack, D> slope;  ///< ∇_a φ, N
    Pack curvature;         ///< of φ along the pair, N/m
  };

  Self self(std::size_t i) const {
    const auto& r = records[i];
    return {i, broadcast(r.x), r.volume, r.bulk_modulus, r.smoothing_length, r.spacing};
  }

  Pair pair(const Self& a, const std::uint32_t* j) const {
    using Record = ContactRecord<D>;
    const auto x = a.x - gathered(records, j, &Record::x);
    const Pack h = Pack(0.5) * (a.h + gathered(records, j, &Record::smoothing_length));
    const Pack spacing = Pack(0.5) * (a.spacing + gathered(records, j, &Record::spacing));
    const KernelPair<Kernel, D> kernel(x, h);
    const Pack at_spacing = kernel_at<Kernel, D>(spacing, h);
    const Pack ratio = kernel.value / at_spacing;  // zero beyond the support
    Pack modulus = smaller(a.bulk_modulus, gathered(records, j, &Record::bulk_modulus));
    for (int k = 0; k < D; ++k) modulus /= spacing;
    const Pack other = select(is_other(a.index, j), Pack(1.0), Pack(0.0));  // by index: places of two bodies may agree
    const Pack strength = other * a.volume * gathered(records, j, &Record::volume) * Pack(factor) * modulus;
    Pack power = 1.0;  // ratio^(n-2)
    for (int k = 2; k < exponent; ++k) power *= ratio;
    const Pack push = strength * Pack(double(exponent)) * power * ratio / at_spacing;
    const Pack curvature = strength * Pack(exponent * (exponent - 1.0)) * power * dot(kernel.slope, kernel.slope) /
                           (at_spacing * at_spacing);
    return {strength * power * ratio * ratio, push * kernel.slope, curvature};
  }
};

}  // namespace tektite
