#pragma once

#include "core/particles.hpp"

namespace tektite {

/// Orders each body's particles by cells of this side in m, so that what is near in space is near in memory; within a
/// cell they keep their order.
template <int D>
void order_in_space(Particles& particles, double side);

}  // namespace tektite
