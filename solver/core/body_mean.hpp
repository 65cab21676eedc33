#pragma once

#include <array>

#include "core/particles.hpp"

namespace tektite {

/// Mean of a vector field over a body by mass, in the field's unit; components that the space has not are zero.
std::array<double, 3> mean_over(const Particles& particles, const Body& body, Field field);

}  // namespace tektite
