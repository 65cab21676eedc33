#pragma once

#include <optional>
#include <vector>

#include "core/scene.hpp"

namespace tektite {

/// What particles may come to: the planes of symmetry, and the anvil.
inline std::vector<SymmetryPlane> walls_of(std::vector<SymmetryPlane> symmetry,
                                           const std::optional<SymmetryPlane>& anvil) {
  if (anvil) symmetry.push_back(*anvil);
  return symmetry;
}

}  // namespace tektite
