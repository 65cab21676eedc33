#pragma once
// Plane stress with an equation of state: the rate of deformation across the plane that leaves σ_zz = s_zz - p at zero.

#include <cmath>

#include "physics/eos/eos.hpp"
#include "physics/strength/advance_deviator.hpp"

namespace tektite {

/// Finds D_zz in 1/s such that s_zz = p after dt under L, with e after the step known, and `bulking`, the pressure on
/// top of that of the equation of state. A secant that starts from the elastic slope; ten steps are more than it has
/// been seen to need, and what is left over after them is carried into the next step, because the condition is on the
/// stress and not on its rate.
template <class EosModel, class StrengthModel>
double plane_stress_rate(const EosModel& eos, const StrengthModel& strength, const Tensor<double, 2>& l, double density,
                         double energy_after, double bulking, double dt, const DeviatorState<2>& state) {
  const auto stress_across = [&](double across) {
    auto after = state;
    advance_deviator(strength, l, across, density, dt, after);
    const double rho = density * std::exp(-(trace(l) + across) * dt);
    return after.stress.c[2] - eos.pressure(rho, energy_after) - bulking;
  };
  const double stiffness =
      density * eos.pressure_by_density(density, energy_after) + 4.0 / 3.0 * strength.shear_modulus;
  double slope = stiffness * dt;
  double rate = -(stiffness - 2.0 * strength.shear_modulus) / stiffness * trace(l);
  double stress = stress_across(rate);
  constexpr int most = 10;
  for (int k = 0; k < most && std::abs(stress) > 1e-10 * stiffness; ++k) {
    const double next = rate - stress / slope;
    const double next_stress = stress_across(next);
    const double secant = (next_stress - stress) / (next - rate);
    if (secant > 0.0) slope = secant;
    rate = next;
    stress = next_stress;
  }
  return rate;
}

}  // namespace tektite
