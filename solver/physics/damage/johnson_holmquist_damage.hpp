#pragma once

#include <algorithm>
#include <array>

#include "physics/damage/damage_state.hpp"
#include "physics/model.hpp"

namespace tektite {

/// Johnson and Holmquist's JH-1: D = Σ Δε_p/ε_f, ε_f rising with the pressure from 0 at T to ε_f,max at P_max; P = T
/// sets D = 1 at once (time-split Godunov paper, eq. 41 and figure 7).
struct JohnsonHolmquistDamage {
  static constexpr std::string_view name = "johnson-holmquist-1";
  double tensile_limit = 0.0;
  double most_strain = 0.0;
  double most_pressure = 0.0;

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
                                   "pressure P_max of the largest failure strain"}};
  }

  bool fails_under(double pressure) const { return pressure <= tensile_limit; }
  double failure_strain(const DamageState& state) const {
    const double part = (state.pressure - tensile_limit) / (most_pressure - tensile_limit);
    return most_strain * std::clamp(part, 0.0, 1.0);
  }
};

}  // namespace tektite
