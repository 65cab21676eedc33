#pragma once

#include <cstdint>

#include "core/pack.hpp"
#include "passes/kernel_pair.hpp"
#include "passes/lagrangian_records.hpp"

namespace tektite {

/// Deformation of Young et al. (2021), eq. 2 and 13: F = I + Σ V_b0 (u_b - u_a) ⊗ ∇̃_0W̃ and its rate.
template <class Kernel, int D>
struct DeformationSums {
  const ReferenceRecord<D>* reference;
  const MotionRecord<D>* motion;
  Tensor<double, D>* deformation;  ///< F
  Tensor<double, D>* rate;         ///< dF/dt, 1/s

  struct Self {
    Vector<Pack, D> reference, x, v;
    Pack h;
    Correction<Pack, D> correction;
  };
  struct Sums {
    Tensor<Pack, D> displacement = Tensor<Pack, D>::zero();
    Tensor<Pack, D> rate = Tensor<Pack, D>::zero();
  };

  Self begin(std::size_t i) const {
    const auto& r = reference[i];
    return {broadcast(r.x), broadcast(motion[i].x), broadcast(motion[i].v), r.smoothing_length,
            broadcast(r.correction)};
  }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto x = a.reference - gathered(reference, j, &ReferenceRecord<D>::x);
    const auto u = gathered(motion, j, &MotionRecord<D>::x) - a.x + x;
    const auto v = gathered(motion, j, &MotionRecord<D>::v) - a.v;
    const KernelPair<Kernel, D> pair(x,
                                     Pack(0.5) * (a.h + gathered(reference, j, &ReferenceRecord<D>::smoothing_length)));
    const Pack volume = gathered(reference, j, &ReferenceRecord<D>::volume) * is_other(x);
    const auto gradient = a.correction.gradient(pair.slope, pair.value);
    for (int r = 0; r < D; ++r)
      for (int c = 0; c < D; ++c) {
        sums.displacement(r, c) += volume * u[r] * gradient[c];
        sums.rate(r, c) += volume * v[r] * gradient[c];
      }
  }

  void end(std::size_t i, const Sums& sums) const {
    for (int r = 0; r < D; ++r)
      for (int c = 0; c < D; ++c) {
        deformation[i](r, c) = (r == c ? 1.0 : 0.0) + sum(sums.displacement(r, c));
        rate[i](r, c) = sum(sums.rate(r, c));
      }
  }
};

/// Forces of Young et al. (2021), eq. 2:
///   a_a = -(1/m_a) Σ V_a0 V_b0 (P_b ∇̃_b0 W̃_ba - P_a ∇̃_a0 W̃_ab)
///       + Σ ½ m_b Π (J_a⁻¹ F_b⁻ᵀ ∇̃_b0 W̃_ba - J_b⁻¹ F_a⁻ᵀ ∇̃_a0 W̃_ab)
///   q_a = Σ ¼ m_b Π (v_b - v_a) · (the same bracket)
/// with m_b/(J_a J_b) = V_b0 ρ_b/J_a, J_a = m_a/(V_a0 ρ_a) and the cofactor C = J F⁻ᵀ. Two Eulerian particles do not
/// act on each other here.
template <class Kernel, class Viscosity, int D>
struct LagrangianForces {
  const ReferenceRecord<D>* reference;
  const MotionRecord<D>* motion;
  const StressRecord<D>* stress;
  Viscosity viscosity;
  const double* mass;
  Vector<double, D>* acceleration;
  double* viscous_power;   ///< W/kg
  double* viscous_signal;  ///< m/s

  struct Self {
    Vector<Pack, D> reference, x, v;
    Tensor<Pack, D> stress, cofactor;
    Pack h, density, sound_speed;
    Correction<Pack, D> correction;
  };
  struct Sums {
    Vector<Pack, D> force = Vector<Pack, D>::zero();
    Vector<Pack, D> viscous = Vector<Pack, D>::zero();
    Pack heat = 0.0;
    Pack signal = 0.0;
  };

  Self begin(std::size_t i) const {
    Self a;
    a.reference = broadcast(reference[i].x);
    a.x = broadcast(motion[i].x);
    a.v = broadcast(motion[i].v);
    a.correction = broadcast(reference[i].correction);
    a.stress = broadcast(stress[i].stress);
    a.cofactor = broadcast(stress[i].cofactor);
    a.h = reference[i].smoothing_length;
    a.density = stress[i].density;
    a.sound_speed = stress[i].sound_speed;
    return a;
  }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto reference_x = a.reference - gathered(reference, j, &ReferenceRecord<D>::x);
    const auto x = a.x - gathered(motion, j, &MotionRecord<D>::x);
    const auto v = a.v - gathered(motion, j, &MotionRecord<D>::v);
    const auto correction = gathered(reference, j, &ReferenceRecord<D>::correction);
    const Pack h = Pack(0.5) * (a.h + gathered(reference, j, &ReferenceRecord<D>::smoothing_length));
    const KernelPair<Kernel, D> pair(reference_x, h);
    const Pack volume = gathered(reference, j, &ReferenceRecord<D>::volume) * is_other(reference_x);

    const auto here = a.correction.gradient(pair.slope, pair.value);              // ∇̃_a0 W̃_ab
    const auto there = correction.gradient(Pack(-1.0) * pair.slope, pair.value);  // ∇̃_b0 W̃_ba
    const auto other_stress = gathered(stress, j, &StressRecord<D>::stress);
    const auto other_cofactor = gathered(stress, j, &StressRecord<D>::cofactor);
    const auto pull = times(a.stress, here) - times(other_stress, there);
    const auto bracket = times(other_cofactor, there) - times(a.cofactor, here);

    const Pack approach = dot(v, x);
    const Pack density = gathered(stress, j, &StressRecord<D>::density);
    const Pack c = Pack(0.5) * (a.sound_speed + gathered(stress, j, &StressRecord<D>::sound_speed));
    const auto [pi, speed] = viscosity(approach, dot(x, x), h, c, Pack(0.5) * (a.density + density));
    // Where the deformation turns the gradients against the line between the particles, Π would drive them, not damp
    // them.
    const Pack power = dot(v, bracket);
    const Pack damping = select(power < Pack(0.0), volume * density * pi, Pack(0.0));
    for (int k = 0; k < D; ++k) {
      sums.force[k] += volume * pull[k];
      sums.viscous[k] += damping * bracket[k];
    }
    sums.heat += damping * power;
    sums.signal = larger(sums.signal, select(pair.value * volume > Pack(0.0), speed, Pack(0.0)));
  }

  void end(std::size_t i, const Sums& sums) const {
    if (reference[i].lagrangian == 0.0) {
      acceleration[i] = Vector<double, D>::zero();
      viscous_power[i] = viscous_signal[i] = 0.0;
      return;
    }
    const double over_mass = reference[i].volume / mass[i];
    const double over_jacobian = over_mass * stress[i].density;
    for (int k = 0; k < D; ++k)
      acceleration[i][k] = over_mass * sum(sums.force[k]) + 0.5 * over_jacobian * sum(sums.viscous[k]);
    viscous_power[i] = -0.25 * over_jacobian * sum(sums.heat);
    viscous_signal[i] = largest(sums.signal);
  }
};

}  // namespace tektite
