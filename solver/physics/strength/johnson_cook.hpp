#pragma once

#include <array>
#include <cmath>

#include "physics/elementary.hpp"
#include "physics/model.hpp"
#include "physics/strength/flow.hpp"

namespace tektite {

/// Johnson and Cook's flow stress,
///   Y = (A + B ε_p^n) (1 + C ln ε̇*) (1 - T*^m),  ε̇* = ε̇_p/ε̇_0,  T* = (T - T_room)/(T_melt - T_room)
/// (time-split Godunov paper, eq. 40). ε̇* below 1 counts as 1: the logarithm was fitted above. T* is kept within 0 and
/// 1, so that molten material has no strength and cold one is not stronger than at room temperature. Plastic work
/// heats: c_v dT = χ dw_p.
struct JohnsonCook {
  static constexpr std::string_view name = "johnson-cook";
  static constexpr StrengthKind kind{true, true, true, true};
  double shear_modulus = 0.0;
  double a = 0.0, b = 0.0, n = 0.0, c = 0.0, m = 0.0;
  double reference_rate = 0.0;
  double room_temperature = 0.0;
  double melting_temperature = 0.0;
  double specific_heat = 0.0;
  double taylor_quinney = 0.0;

  static auto parameters() {
    using M = JohnsonCook;
    return std::array{
        Parameter<M>{"shear_modulus", &M::shear_modulus, dimension::pressure, limits::positive, "shear modulus G"},
        Parameter<M>{"a", &M::a, dimension::pressure, limits::positive, "yield stress A"},
        Parameter<M>{"b", &M::b, dimension::pressure, limits::not_negative, "hardening coefficient B"},
        Parameter<M>{"n", &M::n, dimension::none, {0.0, 2.0}, "hardening exponent n"},
        Parameter<M>{"c", &M::c, dimension::none, {0.0, 1.0}, "rate coefficient C"},
        Parameter<M>{"m", &M::m, dimension::none, {0.0, 10.0, true}, "softening exponent m"},
        Parameter<M>{"reference_rate", &M::reference_rate, dimension::rate, limits::positive, "reference rate", 1.0},
        Parameter<M>{"room_temperature", &M::room_temperature, dimension::temperature, limits::positive,
                     "room temperature", 298.0},
        Parameter<M>{"melting_temperature", &M::melting_temperature, dimension::temperature, limits::positive,
                     "melting temperature"},
        Parameter<M>{"specific_heat", &M::specific_heat, dimension::specific_heat, limits::positive,
                     "specific heat c_v"},
        Parameter<M>{"taylor_quinney", &M::taylor_quinney, dimension::none, limits::fraction,
                     "part χ of the plastic work that heats", 0.9}};
  }
  static auto ascending() {
    using M = JohnsonCook;
    return std::array{
        Ascending<M>{"room_temperature", &M::room_temperature, "melting_temperature", &M::melting_temperature}};
  }

  template <class N = double>
  N flow_stress(const FlowState<N>& state) const {
    return (a + hardening(state.plastic_strain)) * rating(state.plastic_strain_rate) * softening(state);
  }
  /// Powers are most of what plastic flow costs: each is taken once.
  template <class N = double>
  auto flow_in(double step, const FlowState<N>& before) const {
    return [*this, step, strain = before.plastic_strain, soft = softening(before)](const N& increment) {
      const N rate = increment / step, hard = hardening(N(strain + increment)), rated = rating(rate);
      const N by_rate = select(rate > reference_rate, N((a + hard) * c / increment), N(0.0));
      return Flow<N>{(a + hard) * rated * soft, (n * hard / (strain + increment) * rated + by_rate) * soft};
    };
  }

 private:
  template <class N>
  N hardening(const N& strain) const {
    return b * power(strain, n);
  }
  template <class N>
  N rating(const N& plastic_strain_rate) const {
    return 1.0 + c * logarithm(larger(N(plastic_strain_rate / reference_rate), N(1.0)));
  }
  template <class N>
  N softening(const FlowState<N>& state) const {
    const N warmth = (state.temperature - room_temperature) / (melting_temperature - room_temperature);
    return 1.0 - power(smaller(larger(warmth, N(0.0)), N(1.0)), m);
  }
};

}  // namespace tektite
