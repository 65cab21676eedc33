#pragma once

#include "core/particles.hpp"

namespace tektite {

/// Of what neighbours in the reference configuration have moved against each other, the part that no linear motion
/// about a particle describes: Σ|e|² over Σ(|e|² + |E Ξ|²) of all bonds of the body, with e = G Ξ - u as in
/// passes/hourglass_sums.hpp, the nearest neighbours all of one weight, and Green's strain E of G. Kernels of the
/// reference configuration see nothing of it: it is what zero-energy modes, and slip within a kernel, leave. Zero where
/// the body has no total-Lagrangian particles, or where it has not moved.
double bond_mismatch(const Particles& particles, const Body& body);

}  // namespace tektite
