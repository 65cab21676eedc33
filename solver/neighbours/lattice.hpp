#pragma once
// A body whose particles lie on a cubic lattice along the axes: the neighbours of every particle are at the same
// offsets, so no list of them is needed, and what particles side by side read lies side by side.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/pack.hpp"
#include "core/tensor.hpp"

namespace tektite {

/// A box of cells, of which each holds a record or nobody. Cells are numbered row by row; between rows there are as
/// many empty cells as a neighbour can be away, so that the offset of a neighbour never leads to a particle of another
/// row.
template <int D>
class Lattice {
 public:
  static constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

  struct Neighbour {
    std::ptrdiff_t offset;  ///< of its cell from the particle's
    Vector<double, D> x;    ///< X_a - X_b, m
  };

  /// The lattice of the records `members` at these places, with neighbours nearer than `support`. None where they do
  /// not lie on one of this spacing, where two share a cell, or where the box would be nearly empty.
  static std::optional<Lattice> find(std::span<const Vector<double, D>> places, std::span<const std::uint32_t> members,
                                     double spacing, double support);

  /// The record in each cell.
  std::span<const std::uint32_t> records() const { return records_; }
  std::span<const Neighbour> neighbours() const { return neighbours_; }

  /// First cells of the packs of pack_width cells that have to be visited.
  std::span<const std::uint32_t> packs() const { return packs_; }

  /// Visits only packs with a record of which wanted(record) says yes.
  template <class Wanted>
  void visit(const Wanted& wanted) {
    packs_.clear();
    for (std::size_t cell = 0; cell + pack_width <= records_.size();) {
      if (records_[cell] == nobody || !wanted(records_[cell])) {
        ++cell;
        continue;
      }
      packs_.push_back(static_cast<std::uint32_t>(cell));
      cell += pack_width;
    }
  }

  std::size_t memory() const { return sizeof(std::uint32_t) * (records_.capacity() + packs_.capacity()); }

 private:
  std::vector<std::uint32_t> records_;
  std::vector<Neighbour> neighbours_;
  std::vector<std::uint32_t> packs_;
};

}  // namespace tektite
