#pragma once
// Particles that lie nearer to each other than material can: clumps within a body, and bodies or parts of one body that
// have run into each other.

#include <span>

#include "core/particles.hpp"
#include "core/scene.hpp"

namespace tektite {

/// Of what a lattice of the particle's mass and density has between neighbours. A squeeze that keeps the volume brings
/// particles as near at a strain of ln 3 = 1.1.
inline constexpr double too_near_distance = 1.0 / 3.0;

/// The part of a body's particles that have an Eulerian kernel and another such particle of the body too near.
double clumped_part(const Particles& particles, const Body& body);

/// The part of a body's particles that have a particle of another body too near, or one of their own that was further
/// away in the reference configuration than two spacings: kernels of that configuration do not see it.
double interpenetrated_part(const Particles& particles, const Body& body);

/// The part of a body's particles that lie on the wrong side of a symmetry plane: they have passed their own images.
double beyond_planes_part(const Particles& particles, const Body& body, std::span<const SymmetryPlane> planes);

}  // namespace tektite
