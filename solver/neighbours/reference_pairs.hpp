#pragma once

#include "boundary/mirror.hpp"
#include "core/particles.hpp"
#include "neighbours/pair_list.hpp"

namespace tektite {

/// Whose body each particle is, by index.
std::vector<std::uint32_t> body_of_each(const Particles& particles);

/// One for each particle with an Eulerian kernel, zero for the others.
std::vector<std::uint8_t> eulerian_of_each(const Particles& particles);

/// The pairs of each body in the reference configuration that are nearer than `support`; finds the images of `mirror`
/// there. Made once.
template <int D>
PairList reference_pairs(const Particles& particles, Mirror<D>& mirror, double support);

}  // namespace tektite
