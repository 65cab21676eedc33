#pragma once
// How many neighbours a particle has, on average.

#include <algorithm>
#include <vector>

#include "core/particles.hpp"
#include "neighbours/pair_list.hpp"

namespace tektite {

/// Particles of the same body nearer than `reach` in m; images behind symmetry planes are left out.
template <int D>
double mean_neighbours(const Particles& particles, double reach) {
  const auto* own = particles.vectors<D>(Field::position);
  const std::vector<Vector<double, D>> places(own, own + particles.count());
  std::vector<std::uint32_t> body;
  for (std::uint32_t k = 0; k < particles.bodies().size(); ++k)
    body.insert(body.end(), particles.bodies()[k].range.size(), k);
  CellGrid<D> grid;
  grid.build(places, reach);
  PairList pairs;
  pairs.build<D>(grid, places, places.size(), reach, Pairing::within_bodies, body);
  std::size_t count = 0;
  for (const auto& block : pairs.blocks())
    for (std::size_t k = 0; k + 1 < block.first.size(); ++k)
      for (auto n = block.first[k]; n < block.first[k + 1]; ++n) count += block.neighbours[n] != block.begin + k;
  return static_cast<double>(count) / static_cast<double>(places.size());
}

inline double mean_neighbours(const Particles& particles) {
  constexpr double support = 2.0;  // of every kernel
  const double reach = support * std::ranges::max(particles.reals(Field::smoothing_length));
  switch (particles.dimensions()) {
    case 1:
      return mean_neighbours<1>(particles, reach);
    case 2:
      return mean_neighbours<2>(particles, reach);
    default:
      return mean_neighbours<3>(particles, reach);
  }
}

}  // namespace tektite
