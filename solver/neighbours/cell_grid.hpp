#pragma once
// Cells for the search of neighbours. The grid wraps around: a cell's coordinates are taken modulo a power of two, so
// any extent fits into memory proportional to the particles; what falls into a cell from far away is told apart by its
// distance. Each side has at least four cells, so the 3^D cells about a place are all different.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/particles.hpp"
#include "core/tensor.hpp"
#include "passes/vector_box.hpp"

namespace tektite {

/// Where places lie, and how many they are: what a grid is laid out by.
template <int D>
struct Extent {
  VectorBox<D> box;
  std::size_t count = 0;

  static Extent of(std::span<const Vector<double, D>> places) {
    Extent extent;
    extent.count = places.size();
    for (const auto& x : places) extent.box.take(x);
    return extent;
  }
  static void join(Extent& whole, const Extent& part) {
    VectorBox<D>::join(whole.box, part.box);
    whole.count += part.count;
  }
};

template <int D>
class CellGrid {
 public:
  /// Sorts the positions into cells of this side length in m.
  void build(std::span<const Vector<double, D>> positions, double side) {
    build(positions, side, Extent<D>::of(positions));
  }
  /// The same with the cells that places of this extent have, of which these are a part.
  void build(std::span<const Vector<double, D>> positions, double side, const Extent<D>& extent);

  std::size_t cells() const { return first_.size() - 1; }
  /// Which cell a place is in.
  std::size_t cell_of(const Vector<double, D>& x) const;
  /// Indices in a cell, ascending.
  std::span<const std::uint32_t> members(std::size_t cell) const {
    return {members_.data() + first_[cell], members_.data() + first_[cell + 1]};
  }
  /// All indices, cell by cell.
  std::span<const std::uint32_t> members() const { return members_; }
  /// Where a cell's members stand among all.
  Range range_of(std::size_t cell) const { return {first_[cell], first_[cell + 1]}; }
  static constexpr std::size_t around_count = D == 1 ? 3 : D == 2 ? 9 : 27;
  /// A cell and those that touch it, in a fixed order.
  std::array<std::size_t, around_count> around(std::size_t cell) const;

 private:
  std::array<std::int64_t, D> coordinates(const Vector<double, D>& x) const;
  std::size_t index(const std::array<std::int64_t, D>& c) const;

  double side_ = 1.0;
  Vector<double, D> origin_{};
  std::array<std::int64_t, D> size_{};
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> members_;
};

}  // namespace tektite
