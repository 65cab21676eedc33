#pragma once
// Kinetic energy out of nothing: a scheme that keeps the total energy pays for motion that it makes up with internal
// energy, down to below zero.

#include "core/particles.hpp"

namespace tektite {

/// How far the internal energy of a body lies below zero, over its kinetic energy in the frame of its mean velocity; 0
/// where it does not. A material at rest at its reference density has the internal energy zero, and no adiabatic motion
/// leaves it with less. What is less than a billionth of all its kinetic energy is round-off.
double energy_debt(const Particles& particles, const Body& body);

}  // namespace tektite
