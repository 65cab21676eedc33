#pragma once

#include <cstdint>

#include "passes/far.hpp"
#include "passes/godunov_records.hpp"
#include "passes/pair_gradients.hpp"

namespace tektite {

/// The deviatoric half of the time-split Godunov paper's eq. 21 and 32,
///   dṽ/dt = (1/ρ_i) Σ V_j (τ_i + τ_j) ∇W
///   power = (1/ρ_i) Σ V_j (τ_i + τ_j) : ½ (v_j - v_i) ⊗ ∇W
/// (with m_j/(ρ_i ρ_j) = V_j/ρ_i; eq. 32's time-centred velocity takes ½ Δṽ · dṽ/dt from the power, which
/// KickDeviatoric does), and for second order the gradients ∇Q_i = Σ V_j (Q_j - Q_i) ∇W of density, pressure and
/// velocity. With corrected gradients both particles have their own, so that those that accelerate are those that
/// strain, and energy is conserved as well:
///   dṽ/dt = (1/ρ_i) Σ V_j (τ_i ∇̃_iW̃_ij - τ_j ∇̃_jW̃_ji),  power = (1/ρ_i) τ_i : Σ V_j (v_j - v_i) ⊗ ∇̃_iW̃_ij
/// and the gradient that is wanted is that of ṽ, which is summed when it is known.
template <class Kernel, class Smoothing, int D, int order, class Gradients = PlainGradients<D>>
struct DeviatoricRates {
  using Record = DeviatoricRecord<D>;

  const Record* records;
  Smoothing smoothing;
  Vector<double, D>* acceleration;
  double* power;                        ///< W/kg
  HydrodynamicRecord<D>* hydrodynamic;  ///< whose gradients are written
  Gradients gradients = {};

  struct Self {
    Vector<Pack, D> x, v;
    Pack stress[Record::stresses];
    Pack density, pressure, h;
    typename Gradients::Self gradients;
  };
  struct Sums {
    Vector<Pack, D> force = Vector<Pack, D>::zero();
    Pack power = 0.0;
    Vector<Pack, D> density = Vector<Pack, D>::zero();
    Vector<Pack, D> pressure = Vector<Pack, D>::zero();
    Tensor<Pack, D> velocity = Tensor<Pack, D>::zero();
  };

  Self begin(std::size_t i) const {
    const Record& r = records[i];
    Self a;
    a.x = broadcast(r.x);
    a.v = broadcast(r.v);
    broadcast(r.stress, a.stress);
    a.density = r.density;
    a.pressure = r.pressure;
    a.h = r.smoothing_length;
    a.gradients = gradients.begin(i);
    return a;
  }

  bool far(const Self& a, const std::uint32_t* j) const { return all_far<Kernel>(a, records, j, smoothing); }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto other = gather_records<2 * D + Record::stresses + 4>(records, j);
    const Pack* const b = other.number;
    const Pack* const other_stress = b + 2 * D;
    const Pack* const rest = other_stress + Record::stresses;  // volume, density, pressure, smoothing length
    Vector<Pack, D> x, v;                                      // x_ij and v_j - v_i
    for (int k = 0; k < D; ++k) {
      x[k] = a.x[k] - b[k];
      v[k] = b[D + k] - a.v[k];
    }
    const Pack h = smoothing.of_pair(a.h, rest[3]);
    Vector<Pack, D> gradient;  // V_j ∇W
    if constexpr (Gradients::corrected) {
      const auto pair = gradients.of_pair(a.gradients, j, x, h);
      gradient = rest[0] * pair.own;
      const auto other_gradient = rest[0] * pair.other;
      for (int i = 0; i < D; ++i) {
        Pack pull = 0.0, pull_back = 0.0;
        for (int k = 0; k < D; ++k) {
          pull += a.stress[Record::index(i, k)] * gradient[k];
          pull_back += other_stress[Record::index(i, k)] * other_gradient[k];
        }
        sums.force[i] += pull - pull_back;
        sums.power += pull * v[i];
      }
    } else {
      const PairAxis<Kernel, D> pair(x, smoothing.inverse_of(h));
      const Pack weight = rest[0] * pair.slope;
      for (int k = 0; k < D; ++k) gradient[k] = weight * pair.e[k];
      Pack stress[Record::stresses];
      for (int k = 0; k < Record::stresses; ++k) stress[k] = a.stress[k] + other_stress[k];
      for (int i = 0; i < D; ++i) {
        Pack traction = stress[Record::index(i, 0)] * gradient[0];
        for (int k = 1; k < D; ++k) traction += stress[Record::index(i, k)] * gradient[k];
        sums.force[i] += traction;
        sums.power += traction * v[i];
      }
    }
    if constexpr (order == 2) {
      const Pack density = rest[1] - a.density, pressure = rest[2] - a.pressure;
      for (int k = 0; k < D; ++k) {
        sums.density[k] += density * gradient[k];
        sums.pressure[k] += pressure * gradient[k];
        if constexpr (!Gradients::corrected)
          for (int i = 0; i < D; ++i) sums.velocity(i, k) += v[i] * gradient[k];
      }
    }
  }

  void end(std::size_t i, const Sums& sums) const {
    const double inverse = 1.0 / records[i].density;
    for (int k = 0; k < D; ++k) acceleration[i][k] = inverse * sum(sums.force[k]);
    power[i] = (Gradients::corrected ? 1.0 : 0.5) * inverse * sum(sums.power);
    if constexpr (order == 2) {
      auto& h = hydrodynamic[i];
      for (int k = 0; k < D; ++k) h.density_gradient[k] = sum(sums.density[k]);
      for (int k = 0; k < D; ++k) h.pressure_gradient[k] = sum(sums.pressure[k]);
      if constexpr (!Gradients::corrected)
        for (int k = 0; k < D * D; ++k) h.velocity_gradient.c[k] = sum(sums.velocity.c[k]);
    }
  }
};

}  // namespace tektite
