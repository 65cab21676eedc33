#pragma once
// A body whose particles lie on a cubic lattice along the axes: the neighbours of every particle are at the same
// offsets, so no list of them is needed, and what particles side by side read lies side by side.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "core/pack.hpp"
#include "core/tensor.hpp"

namespace tektite {

/// A box of rows of cells, of which each holds a record or nobody. Each row, and the box, has as many empty cells on
/// every side as a neighbour can be away, so that the way to a neighbour never leads to another particle or out of the
/// box; a row has room for a pack between them.
template <int D>
class Lattice {
 public:
  static constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

  using Point = std::array<std::ptrdiff_t, D>;

  struct Neighbour {
    std::ptrdiff_t rows, columns;  ///< from the particle's cell to its own
    Vector<double, D> x;           ///< X_a - X_b, m
    Point steps;                   ///< the same in spacings, the axis of the planes first and that of the rows last
  };

  /// What follows from all members of a lattice, of which a rank may have a part: on it hang the order of neighbours,
  /// and whether there is a lattice at all.
  struct Frame {
    Vector<double, D> anchor;  ///< a lattice point
    double spacing = 0.0;
    Point low = filled(std::numeric_limits<std::ptrdiff_t>::max());  ///< of the box, from the anchor
    Point high = filled(std::numeric_limits<std::ptrdiff_t>::min());
    std::size_t count = 0;
    bool sound = true;  ///< nobody is off the lattice

    static void join(Frame& whole, const Frame& part);
    static Point filled(std::ptrdiff_t value) {
      Point point;
      point.fill(value);
      return point;
    }
  };
  static Frame frame_of(std::span<const Vector<double, D>> places, std::span<const std::uint32_t> members,
                        const Vector<double, D>& anchor, double spacing);

  /// A pack that has to be visited: its first cell, counted row by row, and the first lane that counts, since a pack at
  /// a row's end may begin with cells of the one before.
  struct Visit {
    std::uint32_t cell, lane;
  };

  /// The lattice of the records `members` at these places, with neighbours nearer than `support`. None where they do
  /// not lie on one of this spacing, where two share a cell, or where the box would be nearly empty.
  static std::optional<Lattice> find(std::span<const Vector<double, D>> places, std::span<const std::uint32_t> members,
                                     double spacing, double support);
  /// The same of members of a lattice of this frame; there may be none.
  static std::optional<Lattice> find(std::span<const Vector<double, D>> places, std::span<const std::uint32_t> members,
                                     double support, const Frame& whole);

  /// The record in each cell, row by row.
  std::span<const std::uint32_t> records() const { return records_; }
  /// Cells in a row.
  std::size_t pitch() const { return pitch_; }
  std::size_t rows() const { return records_.size() / pitch_; }
  std::span<const Neighbour> neighbours() const { return neighbours_; }

  /// The packs of wide_pack_width cells that have to be visited. Packs that follow each other are neighbours across the
  /// rows of a plane, and read mostly the same rows: they find them in the cache.
  std::span<const Visit> packs() const { return packs_; }

  /// Visits only packs with a record of which wanted(record) says yes.
  template <class Wanted>
  void visit(const Wanted& wanted) {
    packs_.clear();
    for (std::size_t cell = 0; cell < records_.size();) {
      if (records_[cell] == nobody || !wanted(records_[cell])) {
        ++cell;
        continue;
      }
      const auto column = cell % pitch_, last = pitch_ - margin_ - wide_pack_width;
      const auto lane = column > last ? column - last : 0;
      packs_.push_back({static_cast<std::uint32_t>(cell - lane), static_cast<std::uint32_t>(lane)});
      cell += wide_pack_width - lane;
    }
    const auto along_planes = [this](const Visit& pack) {
      const auto row = pack.cell / pitch_, column = pack.cell % pitch_ / wide_pack_width;
      return std::tuple(row / plane_, column, row);
    };
    std::ranges::stable_sort(packs_, {}, along_planes);
  }

  std::size_t memory() const { return sizeof(std::uint32_t) * records_.capacity() + sizeof(Visit) * packs_.capacity(); }

 private:
  std::size_t pitch_ = 0;
  std::size_t margin_ = 0;  ///< cells that a neighbour can be away
  std::size_t plane_ = 0;   ///< rows of a plane
  std::vector<std::uint32_t> records_;
  std::vector<Neighbour> neighbours_;
  std::vector<Visit> packs_;
};

}  // namespace tektite
