#pragma once

#include <cstdint>

#include "core/pack.hpp"
#include "passes/kernel_pair.hpp"
#include "passes/lagrangian_records.hpp"
#include "physics/artificial_stress.hpp"

namespace tektite {

/// What artificial stress needs of a particle.
struct ArtificialStressRecord {
  double r[3];     ///< R: xx, yy, xy in m⁵/(kg s²)
  double spacing;  ///< Δp, m

  void mirror(int, double) { r[2] = -r[2]; }
};

/// Artificial stress of Eulerian particles on total-Lagrangian ones, in the plane; pairs are those of a
/// total-Lagrangian particle with an Eulerian one. As with viscosity, the gradients of the reference configuration
/// stand for those of the present one: Young et al. (2021), eq. 8 and 9,
///   a_a -= Σ ½ m_b fⁿ (R_b J_a⁻¹ F_b⁻ᵀ ∇̃_b0 W̃_ba - R_a J_b⁻¹ F_a⁻ᵀ ∇̃_a0 W̃_ab),  f = W_ab/W(Δp) at the present places
template <class Kernel>
struct InterfaceStress {
  const ReferenceRecord<2>* reference;
  const MotionRecord<2>* motion;
  const StressRecord<2>* stress;
  const ShiftRecord<2>* shift;  ///< zero without a correction
  const ArtificialStressRecord* artificial;
  ArtificialStress settings;
  const double* mass;
  Vector<double, 2>* acceleration;  ///< is added to
  double* viscous_power;            ///< is added to, W/kg

  struct Self {
    Vector<Pack, 2> reference, x, v;
    Tensor<Pack, 2> cofactor;
    Vector<Pack, 2> cofactor_shift;
    Pack r[3];
    Pack h, spacing;
  };
  struct Sums {
    Vector<Pack, 2> force = Vector<Pack, 2>::zero();
    Pack heat = 0.0;
  };

  Self begin(std::size_t i) const {
    Self a;
    a.reference = broadcast(reference[i].x);
    a.x = broadcast(motion[i].x);
    a.v = broadcast(motion[i].v);
    a.cofactor = broadcast(stress[i].cofactor);
    a.cofactor_shift = broadcast(shift[i].cofactor);
    broadcast(artificial[i].r, a.r);
    a.h = reference[i].smoothing_length;
    a.spacing = artificial[i].spacing;
    return a;
  }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto reference_x = a.reference - gathered(reference, j, &ReferenceRecord<2>::x);
    const auto x = a.x - gathered(motion, j, &MotionRecord<2>::x);
    const auto v = a.v - gathered(motion, j, &MotionRecord<2>::v);
    const auto cofactor = gathered(stress, j, &StressRecord<2>::cofactor);
    const auto cofactor_shift = gathered(shift, j, &ShiftRecord<2>::cofactor);
    Pack r[3];
    gather_into(r, artificial, j, &ArtificialStressRecord::r);
    const Pack h = Pack(0.5) * (a.h + gathered(reference, j, &ReferenceRecord<2>::smoothing_length));
    const Pack spacing = Pack(0.5) * (a.spacing + gathered(artificial, j, &ArtificialStressRecord::spacing));
    const KernelPair<Kernel, 2> pair(reference_x, h), now(x, h);
    const Pack power = closeness<Kernel, 2>(now.value, spacing, h, settings.exponent);

    const auto here = times(a.cofactor, pair.slope) - pair.value * a.cofactor_shift;
    const auto there = Pack(-1.0) * times(cofactor, pair.slope) - pair.value * cofactor_shift;
    const Pack push[2] = {a.r[0] * here[0] + a.r[2] * here[1] - r[0] * there[0] - r[2] * there[1],
                          a.r[2] * here[0] + a.r[1] * here[1] - r[2] * there[0] - r[1] * there[1]};
    const Pack volume = gathered(reference, j, &ReferenceRecord<2>::volume);
    const Pack density = gathered(stress, j, &StressRecord<2>::density);
    // What fills a list up is the particle itself, whose corrected gradient is not zero.
    const Pack factor = volume * density * power * is_other(reference_x);
    for (int k = 0; k < 2; ++k) sums.force[k] += factor * push[k];
    sums.heat += factor * (v[0] * push[0] + v[1] * push[1]);
  }

  void end(std::size_t i, const Sums& sums) const {
    const double over_jacobian = reference[i].volume * stress[i].density / mass[i];
    for (int k = 0; k < 2; ++k) acceleration[i][k] += 0.5 * over_jacobian * sum(sums.force[k]);
    viscous_power[i] -= 0.25 * over_jacobian * sum(sums.heat);
  }
};

}  // namespace tektite
