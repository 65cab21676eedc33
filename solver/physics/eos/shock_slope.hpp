#pragma once

#include <cmath>

#include "physics/eos/eos.hpp"

namespace tektite {

/// A in u_s = c + A Δu for weak shocks into the material at rest, for any equation of state:
///   A = (1 + (ρ/c) (dc/dρ)_s)/2
/// at the reference density, on the side of compression (half of Thompson's fundamental derivative, 1971). For
/// Mie-Grüneisen about u_s = c0 + S1 u_p it is S1, for a stiffened gas (γ + 1)/4. The derivative is a one-sided
/// difference of second order over 1e-3 of the density: an error of 1e-6 times the curvature.
template <class Model>
double shock_slope(const Model& eos) {
  const double rho = eos.reference_density;
  constexpr double width = 1e-3;
  const double stiffness = eos.pressure_by_density(rho, 0.0);
  const auto sound_speed = [&](double zeta) {
    const double energy = 0.5 * stiffness * zeta * zeta;  // along the isentrope, to the order of the difference
    return std::sqrt(sound_speed_squared(eos, rho * (1.0 + zeta), energy));
  };
  const double c = sound_speed(0.0);
  const double slope = (4.0 * sound_speed(width) - sound_speed(2.0 * width) - 3.0 * c) / (2.0 * width);
  return 0.5 * (1.0 + slope / c);
}

/// An ideal gas has (γ + 1)/4 in every state, also in that without energy, where the above is 0/0.
inline double shock_slope(const IdealGas& eos) { return 0.25 * (eos.heat_ratio + 1.0); }

}  // namespace tektite
