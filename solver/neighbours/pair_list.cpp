#include "neighbours/pair_list.hpp"

#include <algorithm>
#include <limits>

#include "core/pack.hpp"
#include "neighbours/compress.hpp"
#include "parallel/for_each.hpp"

namespace tektite {
namespace {

constexpr std::size_t block_size = 256;

/// What the search reads of the positions, in the order of the cells.
template <int D>
struct Places {
  std::span<const std::uint32_t> index;
  std::vector<std::uint32_t> body;
  std::vector<double> x[D];

  Places(const CellGrid<D>& grid, std::span<const Vector<double, D>> positions, std::span<const std::uint32_t> body_of)
      : index(grid.members()), body(index.size()) {
    for (auto& coordinate : x) coordinate.resize(index.size());
    for_each(index.size(), [&](std::size_t n) {
      body[n] = body_of[index[n]];
      for (int k = 0; k < D; ++k) x[k][n] = positions[index[n]][k];
    });
  }
};

/// What lies in the cells about one cell, gathered once for all particles of that cell, and filled up to a whole number
/// of eights with what is near to nothing.
template <int D>
struct Candidates {
  std::vector<std::uint32_t> index;
  std::vector<std::uint32_t> body;
  std::vector<double> x[D];
  std::vector<double> square;
  std::vector<std::uint8_t> other, mark;

  void gather(const CellGrid<D>& grid, const Places<D>& places, std::size_t centre) {
    const auto cells = grid.around(centre);
    std::size_t count = 0;
    for (const auto cell : cells) count += grid.range_of(cell).size();
    const std::size_t filled = (count + compress_width - 1) / compress_width * compress_width;
    index.resize(filled);
    body.resize(filled);
    square.resize(filled);
    other.resize(filled);
    mark.resize(filled);
    for (auto& coordinate : x) coordinate.resize(filled);
    std::size_t n = 0;
    for (const auto cell : cells) {
      const auto range = grid.range_of(cell);
      const auto copy = [&](const auto& from, auto& to) {
        std::copy(from.begin() + range.begin, from.begin() + range.end, to.begin() + n);
      };
      copy(places.index, index);
      copy(places.body, body);
      for (int k = 0; k < D; ++k) copy(places.x[k], x[k]);
      n += range.size();
    }
    for (; n < filled; ++n)
      for (auto& coordinate : x) coordinate[n] = std::numeric_limits<double>::infinity();
  }

  /// Finds how far each is from this place, and who may be paired with a particle of the body `own`.
  template <Pairing pairing>
  void measure(const Vector<double, D>& place, std::uint32_t self, std::uint32_t own) {
    const std::size_t count = index.size();
    for (std::size_t n = 0; n < count; ++n) {
      double sum = 0.0;
      for (int k = 0; k < D; ++k) {
        const double d = x[k][n] - place[k];
        sum += d * d;
      }
      square[n] = sum;
    }
    for (std::size_t n = 0; n < count; ++n) other[n] = index[n] != self ? 1 : 0;
    if constexpr (pairing != Pairing::all)
      for (std::size_t n = 0; n < count; ++n)
        other[n] &= (body[n] == own) == (pairing == Pairing::within_bodies) ? 1 : 0;
  }

  /// Copies those of them to `out` that are at least so far away and nearer than that; says how many.
  std::size_t take(double least, double most, std::span<std::uint32_t> out) {
    const std::size_t count = index.size();
    const double from = least * least, to = most * most;
    for (std::size_t n = 0; n < count; ++n)
      mark[n] = static_cast<std::uint8_t>((square[n] >= from ? 1 : 0) & (square[n] < to ? 1 : 0) & other[n]);
    return compress(index, mark, out);
  }
};

template <int D, Pairing pairing>
void build_block(PairList::Block& block, std::size_t end, const CellGrid<D>& grid,
                 std::span<const Vector<double, D>> positions, const Places<D>& places, const Reach& reach,
                 std::span<const std::uint32_t> body, std::span<const std::uint8_t> listed) {
  Candidates<D> candidates;
  std::size_t last_cell = grid.cells();
  std::vector<std::uint32_t> neighbours;  // with room to spare, which the block does not keep
  std::size_t found = 0;
  block.first.assign(1, 0);
  for (std::size_t i = block.begin; i < end; ++i) {
    if (!listed.empty() && listed[i] == 0) {
      block.first.push_back(static_cast<std::uint32_t>(found));
      continue;
    }
    if (const auto cell = grid.cell_of(positions[i]); cell != last_cell) {
      candidates.gather(grid, places, cell);
      last_cell = cell;
    }
    candidates.template measure<pairing>(positions[i], static_cast<std::uint32_t>(i), body[i]);
    const std::size_t room = found + candidates.index.size() + compress_width;
    if (neighbours.size() < room) neighbours.resize(2 * room);
    found += candidates.take(0.0, reach.support, std::span(neighbours).subspan(found));
    if (reach.all > reach.support)
      found += candidates.take(reach.support, reach.all, std::span(neighbours).subspan(found));
    while (found % pack_width != 0) neighbours[found++] = static_cast<std::uint32_t>(i);
    block.first.push_back(static_cast<std::uint32_t>(found));
  }
  const auto kept = std::span(neighbours).first(found);
  block.neighbours.assign(kept.begin(), kept.end());
}

}  // namespace

template <int D>
void PairList::build(const CellGrid<D>& grid, std::span<const Vector<double, D>> positions, std::size_t count,
                     const Reach& reach, Pairing pairing, std::span<const std::uint32_t> body,
                     std::span<const std::uint8_t> listed) {
  const Places<D> places(grid, positions, body);
  blocks_.resize((count + block_size - 1) / block_size);
  for_each_uneven(blocks_.size(), [&](std::size_t b) {
    auto& block = blocks_[b];
    block.begin = b * block_size;
    const auto end = std::min(count, (b + 1) * block_size);
    switch (pairing) {
      case Pairing::all:
        build_block<D, Pairing::all>(block, end, grid, positions, places, reach, body, listed);
        break;
      case Pairing::within_bodies:
        build_block<D, Pairing::within_bodies>(block, end, grid, positions, places, reach, body, listed);
        break;
      case Pairing::across_bodies:
        build_block<D, Pairing::across_bodies>(block, end, grid, positions, places, reach, body, listed);
        break;
    }
  });
}

std::size_t PairList::memory() const {
  std::size_t bytes = 0;
  for (const auto& block : blocks_)
    bytes += sizeof(std::uint32_t) * (block.first.capacity() + block.neighbours.capacity());
  return bytes;
}

template void PairList::build<1>(const CellGrid<1>&, std::span<const Vector<double, 1>>, std::size_t, const Reach&,
                                 Pairing, std::span<const std::uint32_t>, std::span<const std::uint8_t>);
template void PairList::build<2>(const CellGrid<2>&, std::span<const Vector<double, 2>>, std::size_t, const Reach&,
                                 Pairing, std::span<const std::uint32_t>, std::span<const std::uint8_t>);
template void PairList::build<3>(const CellGrid<3>&, std::span<const Vector<double, 3>>, std::size_t, const Reach&,
                                 Pairing, std::span<const std::uint32_t>, std::span<const std::uint8_t>);

}  // namespace tektite
