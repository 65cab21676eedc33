#pragma once

#include <array>

#include "physics/model.hpp"

namespace tektite {

/// Material that never fails by strain.
struct NoDamage {
  static constexpr std::string_view name = "none";
  static std::array<Parameter<NoDamage>, 0> parameters() { return {}; }
};

}  // namespace tektite
