#pragma once
// Shocks into a material at rest and without pressure, for any equation of state p(ρ, e) that is linear in e, and what
// two materials that meet have in common behind them. Strength is left out: pressures far above the flow stress are
// meant.

#include <algorithm>
#include <cmath>
#include <optional>

#include "physics/eos/eos.hpp"

namespace tektite {

struct ShockedState {
  double pressure = 0.0;        ///< Pa
  double density = 0.0;         ///< kg/m³
  double energy = 0.0;          ///< J/kg
  double particle_speed = 0.0;  ///< u_p, m/s
  double shock_speed = 0.0;     ///< u_s, m/s
};

/// The state on the Hugoniot of compression η = 1 - ρ0/ρ, from the jumps of mass, momentum and energy (Meyers 1994,
/// Dynamic Behavior of Materials, eq. 4.6-4.8): e = p η/(2 ρ0), u_p² = p η/ρ0, u_s = u_p/η. Nothing where there is
/// none: the thermal pressure alone would exceed p.
template <class Model>
std::optional<ShockedState> hugoniot_state(const Model& eos, double eta) {
  const double rho0 = eos.reference_density, rho = rho0 / (1.0 - eta);
  const double thermal = 0.5 * eos.pressure_by_energy(rho, 0.0) * eta / rho0;
  const double p = eos.pressure(rho, 0.0) / (1.0 - thermal);
  if (!(thermal < 1.0 && p > 0.0 && std::isfinite(p))) return std::nullopt;
  const double up = std::sqrt(p * eta / rho0);
  return ShockedState{p, rho, 0.5 * up * up, up, up / eta};
}

/// The shock behind which the material moves with u_p > 0; nothing where the equation of state has none. η is searched
/// up to the first one that is fast enough, so a pole of a fitted Hugoniot is never crossed.
template <class Model>
std::optional<ShockedState> shock_of_speed(const Model& eos, double up) {
  constexpr int steps = 2000;   // of η from 0 to 1
  constexpr int halvings = 60;  // more than a double has digits
  double slower = 0.0, speed = 0.0;
  for (int k = 1; k < steps; ++k) {
    double faster = static_cast<double>(k) / steps;
    auto state = hugoniot_state(eos, faster);
    if (!state || state->particle_speed < speed) return std::nullopt;
    speed = state->particle_speed;
    if (speed < up) {
      slower = faster;
      continue;
    }
    for (int n = 0; n < halvings; ++n) {
      const double middle = 0.5 * (slower + faster);
      const auto between = middle > 0.0 ? hugoniot_state(eos, middle) : std::nullopt;
      (between && between->particle_speed < up ? slower : faster) = middle;
    }
    return hugoniot_state(eos, faster);
  }
  return std::nullopt;
}

struct Impact {
  ShockedState first, second;  ///< in each of the two materials
};

/// A body that meets another one with this closing speed, in m/s, in one dimension: the common pressure and velocity
/// behind both shocks. Nothing where one of the equations of state has no such shock. Source: Meyers 1994, section 4.5.
template <class First, class Second>
std::optional<Impact> match_impedances(const First& first, const Second& second, double closing_speed) {
  constexpr int halvings = 60;
  double low = 0.0, high = closing_speed;  // of u_p in the first; the pressure there rises with it
  for (int n = 0; n < halvings; ++n) {
    const double up = 0.5 * (low + high);
    const auto a = shock_of_speed(first, up);
    const auto b = shock_of_speed(second, closing_speed - up);
    if (!a && !b) return std::nullopt;
    (a && (!b || a->pressure < b->pressure) ? low : high) = up;
  }
  const auto a = shock_of_speed(first, low);
  const auto b = shock_of_speed(second, closing_speed - low);
  if (!a || !b) return std::nullopt;
  return Impact{*a, *b};
}

/// The energy in J/kg that is left when a shocked state has been released to zero pressure along its isentrope, de = p
/// dρ/ρ².
template <class Model>
double energy_after_release(const Model& eos, const ShockedState& shocked) {
  constexpr int steps = 2000;  // from ρ to zero: the error of the midpoint rule is of the order of its square
  const double step = shocked.density / steps;
  double rho = shocked.density, e = shocked.energy;
  while (rho > step && eos.pressure(rho, e) > 0.0) {
    const double middle = rho - 0.5 * step;
    const double e_middle = e - 0.5 * step * eos.pressure(rho, e) / (rho * rho);
    e -= step * std::max(0.0, eos.pressure(middle, e_middle)) / (middle * middle);
    rho -= step;
  }
  return e;
}

}  // namespace tektite
