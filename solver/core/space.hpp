#pragma once
// The spaces in which a scene can live, and the sizes of vectors and tensors in each.

#include <array>
#include <string_view>

namespace tektite {

enum class Space { line, plane_strain, plane_stress, solid };

struct SpaceName {
  Space space;
  std::string_view name;
};

inline constexpr std::array<SpaceName, 4> space_names{{
    {Space::line, "line"},
    {Space::plane_strain, "plane-strain"},
    {Space::plane_stress, "plane-stress"},
    {Space::solid, "solid"},
}};

constexpr std::string_view name_of(Space space) {
  for (const auto& entry : space_names)
    if (entry.space == space) return entry.name;
  return {};
}

/// Number of coordinates that a particle has.
constexpr int dimensions_of(Space space) {
  switch (space) {
    case Space::line:
      return 1;
    case Space::plane_strain:
    case Space::plane_stress:
      return 2;
    case Space::solid:
      return 3;
  }
  return 0;
}

/// Components that a symmetric tensor has in `dimensions` coordinates: always the three normal ones, because stress
/// acts across the plane too, and the shear components within the space. Order: xx yy zz xy yz zx.
constexpr int symmetric_components(int dimensions) { return 3 + dimensions * (dimensions - 1) / 2; }

}  // namespace tektite
