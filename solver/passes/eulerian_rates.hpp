#pragma once

#include <cstdint>

#include "core/pack.hpp"
#include "core/tensor.hpp"
#include "passes/eulerian_record.hpp"
#include "passes/far.hpp"
#include "passes/gathered.hpp"
#include "passes/strain_rate_record.hpp"

namespace tektite {

/// The sums over neighbours of Young et al. (2021), eq. 1, with plain kernels, where ∇_b W_ba = -∇_a W_ab:
///   L_a  = Σ V_b (v_b - v_a) ⊗ ∇W                        dρ/dt = -ρ tr L, stress power σ_a : L_a / ρ_a
///   a_a  = Σ (V_a V_b / m_a) (σ_a + σ_b) ∇W - Σ m_b Π ∇W
///   q_a  = Σ ½ m_b Π v_ab · ∇W                            viscous heating
/// with V_a/m_a = 1/ρ_a and m_b = V_b ρ_b.
template <class Kernel, class Smoothing, class Viscosity, int D>
struct EulerianRates {
  using Record = EulerianRecord<D>;

  const Record* records;
  Smoothing smoothing;
  Viscosity viscosity;
  Vector<double, D>* acceleration;
  Tensor<double, D>* velocity_gradient;
  double* viscous_power;                              ///< q in W/kg
  double* viscous_signal;                             ///< largest |μ| in m/s
  const StrainRateRecord<D>* strain_rates = nullptr;  ///< where the viscosity reconstructs velocities

  struct Self {
    Vector<Pack, D> x, v;
    Pack stress[Record::stresses];
    Pack density, sound_speed, h;
    Vector<Pack, StrainRateRecord<D>::components> rate;
  };
  struct Sums {
    Vector<Pack, D> force = Vector<Pack, D>::zero();    ///< Σ V_b (σ_a + σ_b) ∇W
    Vector<Pack, D> viscous = Vector<Pack, D>::zero();  ///< Σ m_b Π ∇W
    Tensor<Pack, D> gradient = Tensor<Pack, D>::zero();
    Pack heat = 0.0;
    Pack signal = 0.0;
  };

  Self begin(std::size_t i) const {
    const Record& r = records[i];
    Self a;
    a.x = broadcast(r.x);
    a.v = broadcast(r.v);
    broadcast(r.stress, a.stress);
    a.density = r.density;
    a.sound_speed = r.sound_speed;
    a.h = r.smoothing_length;
    if constexpr (Viscosity::reconstructs) a.rate = own(strain_rates, i, &StrainRateRecord<D>::rate);
    return a;
  }

  bool far(const Self& a, const std::uint32_t* j) const { return all_far<Kernel>(a, records, j, smoothing); }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto other = gather_records<2 * D + Record::stresses + 4>(records, j);
    const Pack* const b = other.number;
    const Pack* const other_v = b + D;
    const Pack* const other_stress = other_v + D;
    const Pack volume = other_stress[Record::stresses];
    const Pack density = other_stress[Record::stresses + 1];
    const Pack sound_speed = other_stress[Record::stresses + 2];
    const Pack other_h = other_stress[Record::stresses + 3];

    Vector<Pack, D> x, v;  // x_ab, v_ab
    for (int k = 0; k < D; ++k) {
      x[k] = a.x[k] - b[k];
      v[k] = a.v[k] - other_v[k];
    }
    const Pack h = smoothing.of_pair(a.h, other_h);
    const Pack one_over_h = smoothing.inverse_of(h);
    const Pack r_squared = dot(x, x);
    using std::experimental::sqrt;
    const Pack q = sqrt(r_squared) * one_over_h;
    Pack scale = one_over_h * one_over_h;
    for (int k = 0; k < D; ++k) scale *= one_over_h;
    const Pack slope = select(q < Pack(Kernel::support),
                              Pack(Kernel::template normalisation<D>()) * scale * Kernel::slope_over_q(q), Pack(0.0));

    const Pack weight = volume * slope;  // V_b ∇W = weight x_ab
    const Pack approach = dot(v, x);
    const Pack c = Pack(0.5) * (a.sound_speed + sound_speed);
    const Pack damped = damped_approach<Viscosity>(strain_rates, j, a.rate, x, approach);
    const auto [pi, speed] = viscosity(damped, r_squared, h, c, Pack(0.5) * (a.density + density));
    const Pack damping = weight * density * select(q < Pack(Kernel::support), pi, Pack(0.0));

    Pack stress[Record::stresses];
    for (int k = 0; k < Record::stresses; ++k) stress[k] = weight * (a.stress[k] + other_stress[k]);
    for (int i = 0; i < D; ++i) {
      for (int k = 0; k < D; ++k) sums.force[i] += stress[Record::index(i, k)] * x[k];
      sums.viscous[i] += damping * x[i];
      const Pack across = weight * v[i];
      for (int k = 0; k < D; ++k) sums.gradient(i, k) -= across * x[k];
    }
    sums.heat += damping * approach;
    sums.signal = larger(sums.signal, select(q < Pack(Kernel::support), speed, Pack(0.0)));
  }

  void end(std::size_t i, const Sums& sums) const {
    const double one_over_density = 1.0 / records[i].density;
    for (int k = 0; k < D; ++k) acceleration[i][k] = one_over_density * sum(sums.force[k]) - sum(sums.viscous[k]);
    for (int k = 0; k < D * D; ++k) velocity_gradient[i].c[k] = sum(sums.gradient.c[k]);
    viscous_power[i] = 0.5 * sum(sums.heat);
    viscous_signal[i] = largest(sums.signal);
  }
};

}  // namespace tektite
