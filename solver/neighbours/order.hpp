#pragma once

#include "core/particles.hpp"

namespace tektite {

/// Orders each body's particles by cells of this side in m, so that what is near in space is near in memory; within a
/// cell by their ids. So the order follows from the places alone, and that of some particles is the same with and
/// without the others. Where particles are distributed, each keeps its cell as its sequence.
template <int D>
void order_in_space(Particles& particles, double side);

}  // namespace tektite
