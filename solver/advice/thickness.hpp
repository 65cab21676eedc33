#pragma once

#include "core/particles.hpp"
#include "core/scene.hpp"

namespace tektite {

/// How many particles lie through a body where it is thinnest along a coordinate axis: for each particle the shortest
/// of the rows through it, and of these the middle one. A row that ends at a symmetry plane counts with its image.
double particles_through(const Particles& particles, const Body& body, const std::vector<SymmetryPlane>& symmetry);

}  // namespace tektite
