#include "neighbours/pair_list.hpp"

#include <algorithm>

#include "core/pack.hpp"

namespace tektite {
namespace {

constexpr std::size_t block_size = 256;

/// What lies in the cells about one cell, gathered once for all particles of that cell.
template <int D>
struct Candidates {
  std::vector<std::uint32_t> index;
  std::vector<double> x[D];

  void gather(const CellGrid<D>& grid, std::span<const Vector<double, D>> positions, std::size_t centre) {
    const auto cells = grid.around(centre);
    std::size_t count = 0;
    for (const auto cell : cells) count += grid.members(cell).size();
    index.resize(count);
    for (auto& coordinate : x) coordinate.resize(count);
    std::size_t n = 0;
    for (const auto cell : cells)
      for (const auto j : grid.members(cell)) {
        index[n] = j;
        for (int k = 0; k < D; ++k) x[k][n] = positions[j][k];
        ++n;
      }
  }
};

template <Pairing pairing>
bool paired(std::uint32_t a, std::uint32_t b) {
  return pairing == Pairing::all || (pairing == Pairing::within_bodies ? a == b : a != b);
}

template <int D, Pairing pairing>
void build_block(PairList::Block& block, std::size_t end, const CellGrid<D>& grid,
                 std::span<const Vector<double, D>> positions, double reach, std::span<const std::uint32_t> body) {
  Candidates<D> near;
  std::vector<double> distance;
  std::vector<std::uint32_t> found_here;
  std::size_t last_cell = grid.cells();
  const double reach_squared = reach * reach;
  block.first.assign(1, 0);
  block.neighbours.clear();
  for (std::size_t i = block.begin; i < end; ++i) {
    const auto place = positions[i];
    if (const auto cell = grid.cell_of(place); cell != last_cell) {
      near.gather(grid, positions, cell);
      distance.resize(near.index.size());
      last_cell = cell;
    }
    const std::size_t count = near.index.size();
    for (std::size_t n = 0; n < count; ++n) {
      double square = 0.0;
      for (int k = 0; k < D; ++k) {
        const double d = near.x[k][n] - place[k];
        square += d * d;
      }
      distance[n] = square;
    }
    found_here.resize(count + pack_width);
    auto* out = found_here.data();
    std::size_t found = 0;
    for (std::size_t n = 0; n < count; ++n) {  // without a branch, which would be guessed wrong every third time
      out[found] = near.index[n];
      found += static_cast<std::size_t>(distance[n] < reach_squared) & static_cast<std::size_t>(near.index[n] != i) &
               static_cast<std::size_t>(paired<pairing>(body[i], body[near.index[n]]));
    }
    while (found % pack_width != 0) out[found++] = static_cast<std::uint32_t>(i);
    block.neighbours.insert(block.neighbours.end(), out, out + found);
    block.first.push_back(static_cast<std::uint32_t>(block.neighbours.size()));
  }
}

}  // namespace

template <int D>
void PairList::build(const CellGrid<D>& grid, std::span<const Vector<double, D>> positions, std::size_t count,
                     double reach, Pairing pairing, std::span<const std::uint32_t> body) {
  blocks_.resize((count + block_size - 1) / block_size);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    auto& block = blocks_[b];
    block.begin = b * block_size;
    const auto end = std::min(count, (b + 1) * block_size);
    switch (pairing) {
      case Pairing::all:
        build_block<D, Pairing::all>(block, end, grid, positions, reach, body);
        break;
      case Pairing::within_bodies:
        build_block<D, Pairing::within_bodies>(block, end, grid, positions, reach, body);
        break;
      case Pairing::across_bodies:
        build_block<D, Pairing::across_bodies>(block, end, grid, positions, reach, body);
        break;
    }
  }
}

std::size_t PairList::memory() const {
  std::size_t bytes = 0;
  for (const auto& block : blocks_)
    bytes += sizeof(std::uint32_t) * (block.first.capacity() + block.neighbours.capacity());
  return bytes;
}

template void PairList::build<1>(const CellGrid<1>&, std::span<const Vector<double, 1>>, std::size_t, double, Pairing,
                                 std::span<const std::uint32_t>);
template void PairList::build<2>(const CellGrid<2>&, std::span<const Vector<double, 2>>, std::size_t, double, Pairing,
                                 std::span<const std::uint32_t>);
template void PairList::build<3>(const CellGrid<3>&, std::span<const Vector<double, 3>>, std::size_t, double, Pairing,
                                 std::span<const std::uint32_t>);

}  // namespace tektite
