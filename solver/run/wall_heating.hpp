#pragma once
// Gas that a wall keeps too hot: what a shock heats too much while it is born at a plane or axis stays there.

#include <vector>

#include "core/particles.hpp"
#include "core/scene.hpp"

namespace tektite {

/// The specific internal energy of a body's particles next to a symmetry plane or axis, within three spacings, over
/// that of those between fifteen and twenty from it: the largest ratio of all planes from which these differ by less
/// than a twentieth of those up to twenty-five. One where there is no such plane.
double heat_at_walls(const Particles& particles, const Body& body, const std::vector<SymmetryPlane>& planes);

}  // namespace tektite
