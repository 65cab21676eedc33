#pragma once

#include <array>

#include "physics/model.hpp"
#include "physics/strength/flow.hpp"

namespace tektite {

/// Hypoelastic: shear modulus, no yield.
struct Elastic {
  static constexpr std::string_view name = "elastic";
  static constexpr StrengthKind kind{true, false, false, false};
  double shear_modulus = 0.0;
  static auto parameters() {
    return std::array{Parameter<Elastic>{"shear_modulus", &Elastic::shear_modulus, dimension::pressure,
                                         limits::positive, "shear modulus G"}};
  }
};

}  // namespace tektite
