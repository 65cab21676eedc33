#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/elementary.hpp"
#include "physics/model.hpp"
#include "physics/strength/flow.hpp"

namespace tektite {

/// The ceramic of Johnson and Holmquist (1992), JH-1: the time-split Godunov paper, section 5 and figure 6. Intact, the
/// strength is piecewise linear in the pressure through (T, 0), (P1, σ1), (P2, σ2) and constant above; where D = 1 it
/// is min(c_f P, σ_f) under pressure and nothing in tension. Both are raised by the rate, 1 + C ln ε̇*, ε̇* below 1
/// counting as 1.
struct JohnsonHolmquist {
  static constexpr std::string_view name = "johnson-holmquist-1";
  static constexpr StrengthKind kind{true, true, true, false, true};
  double shear_modulus = 0.0;
  double tensile_limit = 0.0;
  double p1 = 0.0, s1 = 0.0, p2 = 0.0, s2 = 0.0;
  double failed_slope = 0.0;
  double failed_strength = 0.0;
  double c = 0.0;
  double reference_rate = 0.0;

  static auto parameters() {
    using M = JohnsonHolmquist;
    return std::array{
        Parameter<M>{"shear_modulus", &M::shear_modulus, dimension::pressure, limits::positive, "shear modulus G"},
        Parameter<M>{"tensile_limit",
                     &M::tensile_limit,
                     dimension::pressure,
                     {-limits::infinite, 0.0},
                     "pressure T, negative, at which the intact strength is zero"},
        Parameter<M>{"p1", &M::p1, dimension::pressure, limits::positive, "pressure P1"},
        Parameter<M>{"s1", &M::s1, dimension::pressure, limits::positive, "intact strength σ1 at P1"},
        Parameter<M>{"p2", &M::p2, dimension::pressure, limits::positive, "pressure P2"},
        Parameter<M>{"s2", &M::s2, dimension::pressure, limits::positive, "intact strength σ2 at P2"},
        Parameter<M>{"failed_slope", &M::failed_slope, dimension::none, limits::not_negative,
                     "failed strength over pressure c_f"},
        Parameter<M>{"failed_strength", &M::failed_strength, dimension::pressure, limits::not_negative,
                     "largest failed strength σ_f"},
        Parameter<M>{"c", &M::c, dimension::none, {0.0, 1.0}, "rate coefficient C", 0.0},
        Parameter<M>{"reference_rate", &M::reference_rate, dimension::rate, limits::positive, "reference rate", 1.0}};
  }
  static auto ascending() {
    using M = JohnsonHolmquist;
    return std::array{Ascending<M>{"p1", &M::p1, "p2", &M::p2, true}};
  }

  template <class N = double>
  N flow_stress(const FlowState<N>& state) const {
    return strength(state) * rating(state.plastic_strain_rate);
  }
  template <class N = double>
  auto flow_in(double step, const FlowState<N>& before) const {
    return [*this, step, at_rest = strength(before)](const N& increment) {
      const N rate = increment / step;
      return Flow<N>{at_rest * rating(rate), select(rate > reference_rate, N(at_rest * c / increment), N(0.0))};
    };
  }

 private:
  template <class N>
  N rating(const N& plastic_strain_rate) const {
    return 1.0 + c * logarithm(larger(N(plastic_strain_rate / reference_rate), N(1.0)));
  }
  template <class N>
  N strength(const FlowState<N>& state) const {
    const N failed = smaller(larger(N(failed_slope * state.pressure), N(0.0)), N(failed_strength));
    return select(state.damage < 1.0, intact_strength(state.pressure), failed);
  }
  template <class N>
  N intact_strength(const N& p) const {
    const N first = s1 * (p - tensile_limit) / (p1 - tensile_limit), second = s1 + (s2 - s1) * (p - p1) / (p2 - p1);
    return select(p <= tensile_limit, N(0.0), select(p < p1, first, select(p < p2, second, N(s2))));
  }
};

}  // namespace tektite
