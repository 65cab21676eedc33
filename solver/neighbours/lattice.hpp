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
#include <utility>
#include <vector>

#include "core/pack.hpp"
#include "core/tensor.hpp"

namespace tektite {

/// A box of planes of rows of cells, of which each holds a record or nobody. Each row, and the box, has as many empty
/// cells on every side as a neighbour can be away, so that the way to a neighbour never leads to another particle or
/// out of the box; a row has room for a pack between them. In two dimensions a plane is one row, and a line is one
/// plane.
///
/// It is gone through beam by beam: through all planes, in so few rows and columns that what is read of as many planes
/// as neighbours are in stays in a processor's cache, however large the body.
template <int D>
class Lattice {
 public:
  static constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

  using Point = std::array<std::ptrdiff_t, D>;

  struct Neighbour {
    Vector<double, D> x;  ///< X_a - X_b, m
    Point steps;  ///< from the particle's cell to its own, the axis of the planes first and that of the rows last

    std::ptrdiff_t planes() const { return D > 1 ? steps[0] : 0; }
    std::ptrdiff_t rows() const { return D > 2 ? steps[1] : 0; }
    std::ptrdiff_t columns() const { return steps[D - 1]; }
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

  /// The cells of a beam in each plane: `row` and `column` are the first ones.
  struct Beam {
    std::size_t row, rows, column, columns;
  };

  /// What has to be visited of a beam in a plane: packs()[first_pack] and those up to the first one of the next layer.
  struct Layer {
    std::uint32_t beam, plane;
    std::size_t first_pack;
  };

  /// A pack of wide_pack_width cells of a layer: the place of the first one, and the first lane that counts, since a
  /// pack at a row's end may begin with cells of the one before.
  struct Visit {
    std::uint32_t row, column, lane;
  };

  /// The lattice of the records `members` at these places, with neighbours nearer than `support`. None where they do
  /// not lie on one of this spacing, where two share a cell, or where the box would be nearly empty.
  static std::optional<Lattice> find(std::span<const Vector<double, D>> places, std::span<const std::uint32_t> members,
                                     double spacing, double support);
  /// The same of members of a lattice of this frame; there may be none.
  static std::optional<Lattice> find(std::span<const Vector<double, D>> places, std::span<const std::uint32_t> members,
                                     double support, const Frame& whole);

  /// The records in the cells of a row: from the first empty column before it on. Rows and planes are counted from the
  /// first one that is not empty; as far as a neighbour can be away there are empty ones around them.
  std::span<const std::uint32_t> row(std::ptrdiff_t plane, std::ptrdiff_t row) const {
    const auto number = first_row_ + plane * plane_ + row;
    return std::span(records_).subspan(static_cast<std::size_t>(number) * pitch_, pitch_);
  }
  /// Cells that a neighbour can be away, along a row, across the rows of a plane, and across planes.
  std::size_t margin() const { return margin_; }
  std::size_t row_margin() const { return D > 2 ? margin_ : 0; }
  std::size_t plane_margin() const { return D > 1 ? margin_ : 0; }
  std::span<const Neighbour> neighbours() const { return neighbours_; }

  std::span<const Beam> beams() const { return beams_; }
  /// Plane by plane of one beam after the other, without those that have nothing to visit.
  std::span<const Layer> layers() const { return layers_; }
  /// Packs that follow each other are neighbours across the rows of a plane, and read mostly the same rows.
  std::span<const Visit> packs() const { return packs_; }
  /// The packs of a layer, by its number.
  std::span<const Visit> packs_of(std::size_t layer) const {
    const auto first = layers_[layer].first_pack;
    const auto end = layer + 1 < layers_.size() ? layers_[layer + 1].first_pack : packs_.size();
    return packs().subspan(first, end - first);
  }

  /// Visits only packs with a record of which wanted(record) says yes.
  template <class Wanted>
  void visit(const Wanted& wanted) {
    layers_.clear();
    packs_.clear();
    for (std::uint32_t b = 0; b < beams_.size(); ++b)
      for (std::uint32_t plane = 0; plane < planes_; ++plane) {
        const auto first = packs_.size();
        for (std::size_t k = 0; k < beams_[b].rows; ++k) visit_row(beams_[b], plane, beams_[b].row + k, wanted);
        if (packs_.size() == first) continue;
        layers_.push_back({b, plane, first});
        const auto across_rows = [](const Visit& pack) { return std::pair(pack.column / wide_pack_width, pack.row); };
        std::ranges::stable_sort(packs_.begin() + static_cast<std::ptrdiff_t>(first), packs_.end(), {}, across_rows);
      }
  }

  std::size_t memory() const {
    return sizeof(std::uint32_t) * records_.capacity() + sizeof(Visit) * packs_.capacity() +
           sizeof(Layer) * layers_.capacity() + sizeof(Beam) * beams_.capacity();
  }

 private:
  /// Of a plane. The more, the fewer records are read for two beams; the fewer, the sooner the cache holds them.
  static constexpr std::size_t rows_of_beam = D > 2 ? 8 : 1, columns_of_beam = D > 2 ? 64 : 256;

  template <class Wanted>
  void visit_row(const Beam& beam, std::uint32_t plane, std::size_t row, const Wanted& wanted) {
    const auto cells = this->row(plane, static_cast<std::ptrdiff_t>(row));
    const auto end = beam.column + beam.columns, last = end - wide_pack_width;
    for (auto column = beam.column; column < end;) {
      if (cells[column] == nobody || !wanted(cells[column])) {
        ++column;
        continue;
      }
      const auto lane = column > last ? column - last : 0;
      packs_.push_back({static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column - lane),
                        static_cast<std::uint32_t>(lane)});
      column += wide_pack_width - lane;
    }
  }

  std::size_t pitch_ = 0;         ///< cells in a row
  std::size_t margin_ = 0;        ///< cells that a neighbour can be away
  std::size_t planes_ = 0;        ///< that are not empty
  std::ptrdiff_t plane_ = 0;      ///< rows from one plane to the next
  std::ptrdiff_t first_row_ = 0;  ///< that is not empty
  std::vector<std::uint32_t> records_;
  std::vector<Neighbour> neighbours_;
  std::vector<Beam> beams_;
  std::vector<Layer> layers_;
  std::vector<Visit> packs_;
};

}  // namespace tektite
