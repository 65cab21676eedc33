#pragma once

#include <array>

#include "physics/model.hpp"
#include "physics/strength/flow.hpp"

namespace tektite {

/// Elastic-plastic with linear isotropic hardening: Y = σ_y + E_p ε_p, E_p the slope of the flow stress over the
/// plastic strain.
struct IsotropicHardening {
  static constexpr std::string_view name = "isotropic-hardening";
  static constexpr StrengthKind kind{true, true, true, false};
  double shear_modulus = 0.0;
  double yield_stress = 0.0;
  double plastic_modulus = 0.0;
  static auto parameters() {
    using M = IsotropicHardening;
    return std::array{
        Parameter<M>{"shear_modulus", &M::shear_modulus, dimension::pressure, limits::positive, "shear modulus G"},
        Parameter<M>{"yield_stress", &M::yield_stress, dimension::pressure, limits::positive, "yield stress σ_y"},
        Parameter<M>{"plastic_modulus", &M::plastic_modulus, dimension::pressure, limits::not_negative,
                     "plastic modulus E_p"}};
  }
  template <class N = double>
  N flow_stress(const FlowState<N>& state) const {
    return yield_stress + plastic_modulus * state.plastic_strain;
  }
  template <class N = double>
  auto flow_in(double, const FlowState<N>& before) const {
    return [*this, strain = before.plastic_strain](const N& increment) {
      return Flow<N>{yield_stress + plastic_modulus * (strain + increment), plastic_modulus};
    };
  }
};

}  // namespace tektite
