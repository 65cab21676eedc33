#pragma once

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

/// The potential φ = V_a V_b K_ca (W_ab/W(Δp))^n of a pair of different bodies and its force on a,
///   -V_a V_b K_ca n W^(n-1)/W(Δp)^n ∇_a W
/// (Young et al. 2021, eq. 15), with the curvature of φ along the pair, which limits the time step.
template <class Kernel, int D>
struct ContactForces {
  const ContactRecord<D>* records;
  double factor;
  int exponent;  ///< n, at least 2
  const double* mass;
  Vector<double, D>* acceleration;  ///< is added to; null where the energy alone is wanted
  double* stiffness;                ///< N/m; null where the energy alone is wanted
  double* energy;                   ///< this particle's half, J

  struct Self {
    Vector<Pack, D> x;
    Pack volume, bulk_modulus, h, spacing;
  };
  struct Sums {
    Vector<Pack, D> force = Vector<Pack, D>::zero();
    Pack stiffness = 0.0;
    Pack energy = 0.0;
  };

  Self begin(std::size_t i) const {
    const auto& r = records[i];
    return {broadcast(r.x), r.volume, r.bulk_modulus, r.smoothing_length, r.spacing};
  }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    using Record = ContactRecord<D>;
    const auto x = a.x - gathered(records, j, &Record::x);
    const Pack h = Pack(0.5) * (a.h + gathered(records, j, &Record::smoothing_length));
    const Pack spacing = Pack(0.5) * (a.spacing + gathered(records, j, &Record::spacing));
    const KernelPair<Kernel, D> pair(x, h);
    const Pack at_spacing = kernel_at<Kernel, D>(spacing, h);
    const Pack ratio = pair.value / at_spacing;  // zero beyond the support
    Pack modulus = smaller(a.bulk_modulus, gathered(records, j, &Record::bulk_modulus));
    for (int k = 0; k < D; ++k) modulus /= spacing;
    const Pack strength = is_other(x) * a.volume * gathered(records, j, &Record::volume) * Pack(factor) * modulus;
    Pack power = 1.0;  // ratio^(n-2)
    for (int k = 2; k < exponent; ++k) power *= ratio;
    const Pack push = strength * Pack(double(exponent)) * power * ratio / at_spacing;
    for (int k = 0; k < D; ++k) sums.force[k] -= push * pair.slope[k];
    sums.energy += strength * power * ratio * ratio;
    sums.stiffness +=
        strength * Pack(exponent * (exponent - 1.0)) * power * dot(pair.slope, pair.slope) / (at_spacing * at_spacing);
  }

  void end(std::size_t i, const Sums& sums) const {
    energy[i] = 0.5 * sum(sums.energy);
    if (!acceleration) return;
    for (int k = 0; k < D; ++k) acceleration[i][k] += sum(sums.force[k]) / mass[i];
    stiffness[i] = sum(sums.stiffness);
  }
};

}  // namespace tektite
