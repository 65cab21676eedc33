#pragma once
// Symmetry that a scene has and does not use, found in its particles: bodies, masses, velocities and whatever else they
// carry. So it holds for every shape and arrangement, and what is found is the symmetry of what is computed.

#include <vector>

#include "core/particles.hpp"
#include "core/scene.hpp"

namespace tektite {

/// Planes across coordinate axes about which every body is its own mirror image, besides those of the scene; none
/// across the axes in `taken`. What lies above is kept.
std::vector<SymmetryPlane> unused_mirrors(const Particles& particles, const std::vector<SymmetryPlane>& taken);

/// A line about which every body is a body of revolution.
struct Revolution {
  int axis = 0;                  ///< along which it lies; in the plane, 2: it stands on it
  double section_particles = 0;  ///< about so many are needed where a particle stands for a ring
};

/// The axes of revolution of a scene in the plane or in a solid, as far as a spacing tells: a body of fewer than some
/// four particles across may be taken for round.
std::vector<Revolution> unused_revolutions(const Particles& particles, const std::vector<SymmetryPlane>& taken);

}  // namespace tektite
