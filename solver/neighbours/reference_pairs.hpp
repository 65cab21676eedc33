#pragma once

#include "boundary/mirror.hpp"
#include "core/particles.hpp"
#include "neighbours/cell_grid.hpp"
#include "neighbours/pair_list.hpp"

namespace tektite {

/// Whose body each particle is, by index.
std::vector<std::uint32_t> body_of_each(const Particles& particles);

/// One for each particle with an Eulerian kernel, zero for the others.
std::vector<std::uint8_t> eulerian_of_each(const Particles& particles);

/// The particles of the reference configuration and their images in a mirror, with whose body each is.
template <int D>
struct ReferencePlaces {
  std::vector<Vector<double, D>> x;
  std::vector<std::uint32_t> body;
  Extent<D> extent;  ///< of all ranks

  /// Finds the images of `mirror` that are nearer than `support` to it.
  ReferencePlaces(const Particles& particles, Mirror<D>& mirror, double support);
};

/// The pairs of each body in the reference configuration that are nearer than `support`, of the first `count` records;
/// those of which `listed` says zero get an empty list, none where it is empty. Made once.
template <int D>
PairList reference_pairs(const ReferencePlaces<D>& places, std::size_t count, double support,
                         std::span<const std::uint8_t> listed = {});

}  // namespace tektite
