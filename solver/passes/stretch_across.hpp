#pragma once

#include <cmath>

#include "physics/strength/plane_stress.hpp"

namespace tektite {

/// Plane stress: the rate of deformation across the plane that keeps σ_zz at zero over a step.
template <class Eos, class Strength>
struct StretchAcross {
  Eos eos;
  Strength strength;
  const Tensor<double, 2>* velocity_gradient;
  const Symmetric<double, 2>* stress;
  const double* density;
  const double* energy;
  const double* pressure;
  const double* viscous_power;
  const double* bulking_pressure;  ///< may be null where nothing bulks
  const double* plastic_strain;
  const double* temperature;
  const double* damage;  ///< may be null where nothing fails
  double step;
  double* across_rate;  ///< D_zz in 1/s

  void operator()(std::size_t i) const {
    DeviatorState<2> state{stress[i], 0.0, 0.0, 0.0};
    if constexpr (Strength::kind.yields) state.plastic_strain = plastic_strain[i];
    if constexpr (Strength::kind.heats) state.temperature = temperature[i];
    if constexpr (Strength::kind.crushes) {
      state.pressure = pressure[i];
      state.damage = damage ? damage[i] : 0.0;
    }
    const auto& l = velocity_gradient[i];
    const double bulking = bulking_pressure ? bulking_pressure[i] : 0.0;
    const double power = contract(stress[i], symmetric_part(l)) - pressure[i] * trace(l);
    const double energy_after = energy[i] + step * (power / density[i] + viscous_power[i]);
    across_rate[i] = plane_stress_rate(eos, strength, l, density[i], energy_after, bulking, step, state);
  }
};

/// The thickness that follows from it, as a multiple of the initial one.
struct AdvanceThickness {
  const double* across_rate;
  double step;
  double* thickness;

  void operator()(std::size_t i) const { thickness[i] *= std::exp(step * across_rate[i]); }
};

}  // namespace tektite
