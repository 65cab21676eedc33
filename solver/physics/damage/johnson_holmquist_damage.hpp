#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/damage/damage_state.hpp"
#include "physics/model.hpp"

namespace tektite {

/// Johnson and Holmquist's JH-1: D = Σ Δε_p/ε_f, ε_f rising with the pressure from 0 at T to ε_f,max at P_max; P = T
/// sets D = 1 at once (time-split Godunov paper, eq. 41 and figure 7). Bulking, which that paper turns off: the share β
/// of the elastic energy of shear that is lost by failing stays as energy of compression.
struct JohnsonHolmquistDamage {
  static constexpr std::string_view name = "johnson-holmquist-1";
  double tensile_limit = 0.0;
  double most_strain = 0.0;
  double most_pressure = 0.0;
  double bulking = 0.0;

  static auto parameters() {
    using M = JohnsonHolmquistDamage;
    return std::array{Parameter<M>{"tensile_limit",
                                   &M::tensile_limit,
                                   dimension::pressure,
                                   {-limits::infinite, 0.0},
                                   "pressure T, negative, at which it fails at once"},
                      Parameter<M>{"most_strain", &M::most_strain, dimension::none, limits::positive,
                                   "largest failure strain ε_f,max"},
                      Parameter<M>{"most_pressure", &M::most_pressure, dimension::pressure, limits::positive,
                                   "pressure P_max of the largest failure strain"},
                      Parameter<M>{"bulking",
                                   &M::bulking,
                                   dimension::none,
                                   {0.0, 1.0},
                                   "share β of the elastic energy lost by failing that becomes pressure",
                                   0.0}};
  }

  bool fails_under(double pressure) const { return pressure <= tensile_limit; }
  double failure_strain(const DamageState& state) const {
    const double part = (state.pressure - tensile_limit) / (most_pressure - tensile_limit);
    return most_strain * std::clamp(part, 0.0, 1.0);
  }

  /// What failing adds to the pressure p, Pa, for good: ΔP = √(p² + 2 β K1 ΔU) - p with ΔU = (σ² - σ_f²)/(6 G), the
  /// elastic energy of shear lost, J/m³ (Johnson and Holmquist 1994, An improved computational constitutive model for
  /// brittle materials, who have K1 μ for p). Failed material bears no tension: p below zero counts as zero.
  double bulking_pressure(double pressure, double bulk_modulus, double lost) const {
    const double p = std::max(pressure, 0.0);
    return std::sqrt(p * p + 2.0 * bulking * bulk_modulus * lost) - p;
  }
};

}  // namespace tektite
