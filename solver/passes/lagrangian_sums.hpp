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
    Self a;
    for (int k = 0; k < D; ++k) {
      a.reference[k] = reference[i].x[k];
      a.x[k] = motion[i].x[k];
      a.v[k] = motion[i].v[k];
      a.correction.shift[k] = reference[i].correction.shift[k];
    }
    for (int k = 0; k < D * D; ++k) a.correction.matrix.c[k] = reference[i].correction.matrix.c[k];
    a.h = reference[i].smoothing_length;
    return a;
  }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto from = [&](const auto* records, auto member) {
      return Pack([&](auto lane) { return member(records[j[static_cast<std::size_t>(lane)]]); });
    };
    Vector<Pack, D> x, u, v;
    for (int k = 0; k < D; ++k) {
      x[k] = a.reference[k] - from(reference, [k](const auto& r) { return r.x[k]; });
      u[k] = from(motion, [k](const auto& r) { return r.x[k]; }) - a.x[k] + x[k];
      v[k] = from(motion, [k](const auto& r) { return r.v[k]; }) - a.v[k];
    }
    const KernelPair<Kernel, D> pair(
        x, Pack(0.5) * (a.h + from(reference, [](const auto& r) { return r.smoothing_length; })));
    const Pack volume = from(reference, [](const auto& r) { return r.volume; }) * is_other(x);
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
    for (int k = 0; k < D; ++k) {
      a.reference[k] = reference[i].x[k];
      a.x[k] = motion[i].x[k];
      a.v[k] = motion[i].v[k];
      a.correction.shift[k] = reference[i].correction.shift[k];
    }
    for (int k = 0; k < D * D; ++k) {
      a.stress.c[k] = stress[i].stress.c[k];
      a.cofactor.c[k] = stress[i].cofactor.c[k];
      a.correction.matrix.c[k] = reference[i].correction.matrix.c[k];
    }
    a.h = reference[i].smoothing_length;
    a.density = stress[i].density;
    a.sound_speed = stress[i].sound_speed;
    return a;
  }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto from = [&](const auto* records, auto member) {
      return Pack([&](auto lane) { return member(records[j[static_cast<std::size_t>(lane)]]); });
    };
    Vector<Pack, D> reference_x, x, v;
    Correction<Pack, D> correction;
    for (int k = 0; k < D; ++k) {
      reference_x[k] = a.reference[k] - from(reference, [k](const auto& r) { return r.x[k]; });
      x[k] = a.x[k] - from(motion, [k](const auto& r) { return r.x[k]; });
      v[k] = a.v[k] - from(motion, [k](const auto& r) { return r.v[k]; });
      correction.shift[k] = from(reference, [k](const auto& r) { return r.correction.shift[k]; });
    }
    for (int k = 0; k < D * D; ++k)
      correction.matrix.c[k] = from(reference, [k](const auto& r) { return r.correction.matrix.c[k]; });
    const Pack h = Pack(0.5) * (a.h + from(reference, [](const auto& r) { return r.smoothing_length; }));
    const KernelPair<Kernel, D> pair(reference_x, h);
    const Pack volume = from(reference, [](const auto& r) { return r.volume; }) * is_other(reference_x);

    const auto here = a.correction.gradient(pair.slope, pair.value);              // ∇̃_a0 W̃_ab
    const auto there = correction.gradient(Pack(-1.0) * pair.slope, pair.value);  // ∇̃_b0 W̃_ba
    Tensor<Pack, D> other_stress, other_cofactor;
    for (int k = 0; k < D * D; ++k) {
      other_stress.c[k] = from(stress, [k](const auto& r) { return r.stress.c[k]; });
      other_cofactor.c[k] = from(stress, [k](const auto& r) { return r.cofactor.c[k]; });
    }
    const auto pull = times(a.stress, here) - times(other_stress, there);
    const auto bracket = times(other_cofactor, there) - times(a.cofactor, here);

    const Pack approach = dot(v, x);
    const Pack density = from(stress, [](const auto& r) { return r.density; });
    const Pack c = Pack(0.5) * (a.sound_speed + from(stress, [](const auto& r) { return r.sound_speed; }));
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
