#pragma once

#include "core/particles.hpp"
#include "physics/material.hpp"

namespace tektite {

/// The energy of zero-energy modes, over it and all that a body has stored and dissipated. Kernels of the reference
/// configuration see nothing of what neighbours there have moved against each other beside a linear motion,
/// e = G Ξ - u as in passes/hourglass_sums.hpp, here with the nearest neighbours all of one weight. Counted is what a
/// shear strain as large, |E|² = D Σ|e|²/Σ|Ξ|², would cost: μ |E|² with the shear modulus μ; beside it stand
/// p²/(2K) + s:s/(4μ), plastic and viscous work. Slip within a kernel counts too. Zero where the body has no
/// total-Lagrangian particles, no strength, or nothing stored; strains below 1e-9 are round-off of places, and count as
/// none.
double hourglass_share(const Particles& particles, const Body& body, const Material& material);

}  // namespace tektite
