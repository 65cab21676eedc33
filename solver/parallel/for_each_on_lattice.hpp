#pragma once
// The loop over pairs of a lattice: wide_pack_width particles side by side collect from the neighbours at one offset
// after the other.

#include <algorithm>
#include <cstddef>
#include <span>

#include "core/pack.hpp"
#include "neighbours/lattice.hpp"
#include "parallel/for_each.hpp"

namespace tektite {

/// A pair of a lattice: what it is, and the way to the neighbour in numbers of transposed records.
template <class Pair>
struct LatticePair {
  Pair pair;
  std::ptrdiff_t way;
};

/// Some packs, on one thread. Flattened as gather_block is.
template <int D, class Rows, class Pair, class Pass>
[[gnu::flatten]] void gather_packs(const Lattice<D>& lattice, const Rows& rows,
                                   std::span<const typename Lattice<D>::Visit> packs,
                                   std::span<const LatticePair<Pair>> pairs, const Pass& pass, std::size_t count) {
  for (const auto& pack : packs) {
    const std::size_t first = pack.cell;
    const auto place = rows.place(first);
    const auto self = pass.begin(place);
    typename Pass::Sums sums;
    for (const auto& [pair, way] : pairs) pass.add(self, pair, place + way, sums);
    const auto whole = sums;  // taking lanes out of `sums` itself would put them into memory in every turn of the loop
    for (std::size_t lane = pack.lane; lane < wide_pack_width; ++lane)
      if (const auto i = lattice.records()[first + lane]; i < count) pass.end(i, whole, lane);
  }
}

/// For every pack of the lattice: pass.begin(place), then pass.add(self, pair, place, sums) for every pair, where the
/// neighbours stand in `rows`; then pass.end(i, sums, lane) for each of the pack's records below `count`, the others
/// being images.
template <int D, class Rows, class Pair, class Pass>
void for_each_on_lattice(const Lattice<D>& lattice, const Rows& rows, std::span<const LatticePair<Pair>> pairs,
                         const Pass& pass, std::size_t count) {
  constexpr std::size_t chunk = 64;
  const auto packs = lattice.packs();
  for_each_uneven((packs.size() + chunk - 1) / chunk, [&](std::size_t k) {
    const auto first = k * chunk;
    gather_packs(lattice, rows, packs.subspan(first, std::min(chunk, packs.size() - first)), pairs, pass, count);
  });
}

}  // namespace tektite
