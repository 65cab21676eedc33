#pragma once
// Which particles of a body still hang together.
//
// Two particles of one body belong together while they are nearer than `link` times their mean smoothing length, and
// neither of them is severed: that one is a fragment of its own. In a radial space a particle is a ring or a shell, and
// on both sides of the axis the same one. VTK's
// vtkEuclideanClusterExtraction knows one fixed radius, no bodies, and asks a locator point by point; the cell grid
// with union-find here takes the radius from the pair and is linear in the number of particles.

#include <vector>

#include "postprocess/whole.hpp"

namespace tektite {

/// The link length in smoothing lengths: the support of the kernels of core, 2 h. Particles farther apart than that
/// exchange no force, so the model itself holds them for separate, and ones that are nearer still pull on each other. A
/// shorter link would cut a body in two where it is only stretched: a lattice drawn to twice its length along one
/// direction has rows 2 δ apart, which is beyond h = 1.4 δ.
inline constexpr double link_of_support = 2.0;

/// The other choice that could be defended, one smoothing length: measures report how far they move with it.
inline constexpr double link_of_smoothing_length = 1.0;

struct Fragment {
  std::int32_t body = 0;
  std::size_t count = 0;           ///< of particles; a ring is one
  double mass = 0.0;               ///< in kg
  Point centre = Point::zero();    ///< of mass, in m
  Point velocity = Point::zero();  ///< of the centre of mass, in m/s
};

struct Fragments {
  std::vector<std::uint32_t> label;  ///< one a particle: index into `list`
  std::vector<Fragment> list;        ///< body after body, the heaviest first

  /// The heaviest fragment of a body.
  std::uint32_t heaviest(std::int32_t body) const;
};

Fragments find_fragments(const Whole& whole, double link);

}  // namespace tektite
