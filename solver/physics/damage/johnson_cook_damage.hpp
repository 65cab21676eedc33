#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/damage/damage_state.hpp"
#include "physics/model.hpp"

namespace tektite {

/// Johnson and Cook (1985): D = Σ Δε_p/ε_f with
///   ε_f = (D1 + D2 exp(D3 σ*)) (1 + D4 ln ε̇*) (1 + D5 T*),
/// ε̇* below 1 counting as 1 and T* kept within 0 and 1 as in the flow stress.
struct JohnsonCookDamage {
  static constexpr std::string_view name = "johnson-cook";
  double d1 = 0.0, d2 = 0.0, d3 = 0.0, d4 = 0.0, d5 = 0.0;
  double reference_rate = 0.0;
  double room_temperature = 0.0;
  double melting_temperature = 0.0;

  static auto parameters() {
    using M = JohnsonCookDamage;
    return std::array{
        Parameter<M>{"d1", &M::d1, dimension::none, limits::any, "failure strain D1"},
        Parameter<M>{"d2", &M::d2, dimension::none, limits::any, "its part D2 that depends on the triaxiality", 0.0},
        Parameter<M>{"d3", &M::d3, dimension::none, limits::any, "exponent D3 of the triaxiality", 0.0},
        Parameter<M>{"d4", &M::d4, dimension::none, limits::any, "rate coefficient D4", 0.0},
        Parameter<M>{"d5", &M::d5, dimension::none, limits::any, "temperature coefficient D5", 0.0},
        Parameter<M>{"reference_rate", &M::reference_rate, dimension::rate, limits::positive, "reference rate", 1.0},
        Parameter<M>{"room_temperature", &M::room_temperature, dimension::temperature, limits::positive,
                     "room temperature", 298.0},
        Parameter<M>{"melting_temperature", &M::melting_temperature, dimension::temperature, limits::positive,
                     "melting temperature", 1e4}};
  }
  static auto ascending() {
    using M = JohnsonCookDamage;
    return std::array{
        Ascending<M>{"room_temperature", &M::room_temperature, "melting_temperature", &M::melting_temperature}};
  }

  double failure_strain(const DamageState& state) const {
    const double rate = state.plastic_strain_rate / reference_rate;
    const double warmth = (state.temperature - room_temperature) / (melting_temperature - room_temperature);
    constexpr double most = 500.0;  // an exponent beyond is no failure strain any more, but an overflow
    const double by_triaxiality = std::exp(std::clamp(d3 * state.triaxiality, -most, most));
    return (d1 + d2 * by_triaxiality) * (rate > 1.0 ? 1.0 + d4 * std::log(rate) : 1.0) *
           (1.0 + d5 * std::clamp(warmth, 0.0, 1.0));
  }
};

}  // namespace tektite
