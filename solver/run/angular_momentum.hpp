#pragma once
// How much a run turns. Pressure between two particles acts along the line between them and keeps it; shear stress and
// viscosity keep it only where their gradients are exact for a rotation.

#include <vector>

#include "core/particles.hpp"

namespace tektite {

/// Axes about which something can turn: all three in the space solid, z in the plane, none in the others.
std::vector<int> axes_of_turning(Space space);

/// About the centre of mass and each of the axes_of_turning(), kg m²/s (per metre of thickness in the plane).
std::vector<double> angular_momentum_of(const Particles& particles);

/// What it would be if all turned one way: Σ m |x - X| |v - V|, with centre of mass X and mean velocity V.
double largest_angular_momentum_of(const Particles& particles);

}  // namespace tektite
