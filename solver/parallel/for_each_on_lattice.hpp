#pragma once
// The loop over pairs of a lattice: wide_pack_width particles side by side collect from the neighbours at one offset
// after the other.

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/pack.hpp"
#include "neighbours/lattice.hpp"
#include "parallel/for_each.hpp"
#include "parallel/threads.hpp"

namespace tektite {

/// Some packs of a layer, which stand in `window`, on one thread. `ways` lead from a particle to its neighbours there,
/// in the order of `pairs`. Flattened as gather_block is.
template <int D, class Window, class Pair, class Pass>
[[gnu::flatten]] void gather_packs(const Lattice<D>& lattice, const typename Lattice<D>::Layer& layer,
                                   std::span<const typename Lattice<D>::Visit> packs, const Window& window,
                                   std::span<const Pair> pairs, std::span<const std::ptrdiff_t> ways, const Pass& pass,
                                   std::size_t count) {
  for (const auto& pack : packs) {
    const auto place = window.place(layer.plane, pack.row, pack.column);
    const auto self = pass.begin(place);
    typename Pass::Sums sums;
    for (std::size_t k = 0; k < pairs.size(); ++k) pass.add(self, pairs[k], place + ways[k], sums);
    const auto whole = sums;  // taking lanes out of `sums` itself would put them into memory in every turn of the loop
    const auto cells = lattice.row(layer.plane, pack.row);
    for (std::size_t lane = pack.lane; lane < wide_pack_width; ++lane)
      if (const auto i = cells[pack.column + lane]; i < count) pass.end(i, whole, lane);
  }
}

/// Deals the layers of the lattice to the threads: work(first, end, window) for runs of layers with about as many packs
/// each, where `windows` has one for every thread.
template <int D, class Window, class Work>
void for_each_on_lattice(const Lattice<D>& lattice, std::vector<Window>& windows, const Work& work) {
  // Each run begins with an empty window. So many a thread that one which is late leaves little to wait for, but runs
  // that are a few times as long as a window.
  constexpr std::size_t runs_of_a_thread = 8, least_windows = 3;
  const auto layers = lattice.layers();
  const auto longest = layers.size() / (least_windows * (2 * lattice.plane_margin() + 1));
  const auto threads = static_cast<std::size_t>(threads_in_use());
  const auto runs = std::clamp(longest, std::size_t{1}, runs_of_a_thread * threads);
  const auto packs = lattice.packs().size();
  const auto begin_of = [&](std::size_t run) {
    const auto layer = std::ranges::lower_bound(layers, run * packs / runs, {}, &Lattice<D>::Layer::first_pack);
    return static_cast<std::size_t>(layer - layers.begin());
  };
  for_each_uneven(runs, windows, [&](std::size_t run, Window& window) {
    work(begin_of(run), run + 1 < runs ? begin_of(run + 1) : layers.size(), window);
  });
}

}  // namespace tektite
