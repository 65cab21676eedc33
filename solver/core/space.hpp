#pragma once
// The spaces in which a scene can live, and the sizes of vectors and tensors in each.

#include <array>
#include <string_view>

namespace tektite {

enum class Space { line, plane_strain, plane_stress, solid, cylindrical, spherical, axisymmetric };

struct SpaceName {
  Space space;
  std::string_view name;
};

inline constexpr std::array<SpaceName, 7> space_names{{
    {Space::line, "line"},
    {Space::plane_strain, "plane-strain"},
    {Space::plane_stress, "plane-stress"},
    {Space::solid, "solid"},
    {Space::cylindrical, "cylindrical"},
    {Space::spherical, "spherical"},
    {Space::axisymmetric, "axisymmetric"},
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
    case Space::cylindrical:
    case Space::spherical:
      return 1;
    case Space::plane_strain:
    case Space::plane_stress:
    case Space::axisymmetric:
      return 2;
    case Space::solid:
      return 3;
  }
  return 0;
}

/// Whether the space is a slice of constant direction across it, which a section through an axis is not.
constexpr bool is_plane(Space space) { return space == Space::plane_strain || space == Space::plane_stress; }

/// Directions about the axis or centre in which motion along the radius, the coordinate x, stretches matter: a ring's
/// one (cylindrical, axisymmetric), a shell's two (spherical), none elsewhere.
constexpr int hoops_of(Space space) {
  if (space == Space::spherical) return 2;
  return space == Space::cylindrical || space == Space::axisymmetric ? 1 : 0;
}

/// Components that a symmetric tensor has in `dimensions` coordinates: always the three normal ones, because stress
/// acts across the plane too, and the shear components within the space. Order: xx yy zz xy yz zx.
constexpr int symmetric_components(int dimensions) { return 3 + dimensions * (dimensions - 1) / 2; }

}  // namespace tektite
