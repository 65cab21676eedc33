#pragma once

#include <array>

#include "physics/model.hpp"
#include "physics/strength/flow.hpp"

namespace tektite {

/// Elastic, perfectly plastic with the von Mises condition √(3/2 s:s) ≤ σ_y.
struct PerfectlyPlastic {
  static constexpr std::string_view name = "perfectly-plastic";
  static constexpr StrengthKind kind{true, true, false, false};
  double shear_modulus = 0.0;
  double yield_stress = 0.0;
  static auto parameters() {
    using M = PerfectlyPlastic;
    return std::array{
        Parameter<M>{"shear_modulus", &M::shear_modulus, dimension::pressure, limits::positive, "shear modulus G"},
        Parameter<M>{"yield_stress", &M::yield_stress, dimension::pressure, limits::positive, "yield stress σ_y"}};
  }
  template <class N = double>
  N flow_stress(const FlowState<N>&) const {
    return yield_stress;
  }
};

}  // namespace tektite
