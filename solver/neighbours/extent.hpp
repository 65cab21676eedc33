#pragma once
// The extents of particles of all ranks, by which each rank lays out the same cells.

#include "neighbours/cell_grid.hpp"
#include "parallel/ranks.hpp"

namespace tektite {

/// Of the particles in a range that are at these places, each counted by its owner alone.
template <int D>
Extent<D> extent_of_owned(const Particles& particles, const Range& range, const Vector<double, D>* places) {
  auto extent = Extent<D>::of({places + range.begin, range.size()});
  if (!distributed(particles)) return extent;
  const auto owner = particles.integers(Field::owner).subspan(range.begin, range.size());
  extent.count = static_cast<std::size_t>(std::ranges::count(owner, rank()));
  return over_ranks(particles, extent, Extent<D>::join);
}

/// Of places of particles and images, of which ranks may have the same ones: its count says no more than that each
/// rank has so many.
template <int D>
Extent<D> extent_of_all(const Particles& particles, std::span<const Vector<double, D>> places) {
  return over_ranks(particles, Extent<D>::of(places), Extent<D>::join);
}

}  // namespace tektite
