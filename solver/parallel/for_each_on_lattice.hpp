#pragma once
// The loop over pairs of a lattice: wide_pack_width particles side by side collect from the neighbours at one offset
// after the other.

#include <algorithm>
#include <cstddef>
#include <span>

#include "core/pack.hpp"
#include "neighbours/lattice.hpp"

namespace tektite {

/// Some packs, on one thread. Flattened as gather_block is.
template <int D, class Pair, class Pass>
[[gnu::flatten]] void gather_packs(const Lattice<D>& lattice, std::span<const std::uint32_t> packs,
                                   std::span<const Pair> pairs, const Pass& pass, std::size_t count) {
  const auto neighbours = lattice.neighbours();
  for (const std::size_t first : packs) {
    const LatticeCell cell{first / lattice.pitch(), first % lattice.pitch()};
    const auto self = pass.begin(cell);
    typename Pass::Sums sums;
    for (std::size_t n = 0; n < neighbours.size(); ++n) pass.add(self, pairs[n], neighbours[n].from(cell), sums);
    for (std::size_t lane = 0; lane < wide_pack_width; ++lane)
      if (const auto i = lattice.records()[first + lane]; i < count) pass.end(i, sums, lane);
  }
}

/// For every pack of the lattice: pass.begin(cell), then pass.add(self, pair, cell, sums) for every neighbour, whose
/// pair stands in `pairs` in the same order; then pass.end(i, sums, lane) for each of the pack's records below `count`,
/// the others being images.
template <int D, class Pair, class Pass>
void for_each_on_lattice(const Lattice<D>& lattice, std::span<const Pair> pairs, const Pass& pass, std::size_t count) {
  constexpr std::size_t chunk = 64;
  const auto packs = lattice.packs();
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t first = 0; first < packs.size(); first += chunk)
    gather_packs(lattice, packs.subspan(first, std::min(chunk, packs.size() - first)), pairs, pass, count);
}

}  // namespace tektite
