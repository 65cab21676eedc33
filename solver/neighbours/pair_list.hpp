#pragma once
// Who is near whom. Neighbours stand in the order of the cells and, within a cell, of their indices, so the list
// follows from the positions alone; each list is filled up with the particle itself to a whole number of packs.

#include <cstdint>
#include <span>
#include <vector>

#include "core/tensor.hpp"
#include "neighbours/cell_grid.hpp"

namespace tektite {

/// Which particles are paired.
enum class Pairing { all, within_bodies, across_bodies };

class PairList {
 public:
  /// A run of particles that one thread takes at a time.
  struct Block {
    std::size_t begin = 0;
    std::vector<std::uint32_t> first;  ///< where each particle's neighbours begin; one more entry than particles
    std::vector<std::uint32_t> neighbours;
  };

  /// Lists, for the first `count` of the positions, the others nearer than `reach` that they are paired with; the rest
  /// are images. `body` says whose each position is.
  template <int D>
  void build(const CellGrid<D>& grid, std::span<const Vector<double, D>> positions, std::size_t count, double reach,
             Pairing pairing, std::span<const std::uint32_t> body);

  const std::vector<Block>& blocks() const { return blocks_; }
  std::size_t memory() const;

 private:
  std::vector<Block> blocks_;
};

}  // namespace tektite
