#pragma once

#include <array>

#include "physics/model.hpp"
#include "physics/strength/flow.hpp"

namespace tektite {

/// A fluid: pressure only.
struct NoStrength {
  static constexpr std::string_view name = "none";
  static constexpr StrengthKind kind{false, false, false, false};
  double shear_modulus = 0.0;
  static std::array<Parameter<NoStrength>, 0> parameters() { return {}; }
};

}  // namespace tektite
