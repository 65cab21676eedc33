#pragma once
// Records of a part of a lattice, row by row, and in a row number by number: the k-th number of all its cells, then the
// next one. A pass reads a member of wide_pack_width cells side by side with one load a number, by the names that it
// uses for records that it gathers. All that it reads of the few rows near a particle then lies on a few pages of
// memory.

#include <algorithm>
#include <span>
#include <vector>

#include "core/pack.hpp"
#include "neighbours/lattice.hpp"
#include "parallel/for_each.hpp"
#include "passes/gathered.hpp"

namespace tektite {

/// Where the first number of a cell stands, counted from that of the first cell of all.
using LatticePlace = std::ptrdiff_t;

/// What a pass sees of one kind of records. Record: a struct of doubles.
template <class Record>
struct Transposed {
  const double* numbers;  ///< the first number of the first cell
  std::ptrdiff_t pitch;   ///< cells in a row
};

template <class Record>
struct NumberOf<Transposed<Record>> {
  using Type = WidePack;
};

/// number(record), a reference to one, of the cells from this one on.
template <class Record, class Number>
[[gnu::always_inline]] inline WidePack gathered_by(const Transposed<Record>& t, LatticePlace place,
                                                   const Number& number) {
  static constexpr Record any{};
  const auto k = &number(any) - reinterpret_cast<const double*>(&any);
  return WidePack(t.numbers + place + k * t.pitch, std::experimental::element_aligned);
}

/// A member of the particles themselves, each in its lane.
template <class Record, class Owner, class Member>
[[gnu::always_inline]] inline auto own(const Transposed<Record>& t, LatticePlace place, Member Owner::*member) {
  return gathered(t, place, member);
}

/// Holds copies of the records of as many planes of a beam as a pass reads for one of them, those around it, and moves
/// on with it plane by plane. A plane takes the room of the one that is no longer read.
class TransposedWindow {
 public:
  /// Room for any beam of this lattice, with `kept` numbers a cell; empty at first.
  template <int D>
  void prepare(const Lattice<D>& lattice, std::size_t kept) {
    std::size_t rows = 0, columns = 0;
    for (const auto& beam : lattice.beams()) {
      rows = std::max(rows, beam.rows);
      columns = std::max(columns, beam.columns);
    }
    rows_ = rows + 2 * lattice.row_margin();
    pitch_ = (columns + 2 * lattice.margin() + pack_width - 1) / pack_width * pack_width;
    planes_ = 2 * lattice.plane_margin() + 1;
    kept_ = kept;
    beam_ = nullptr;
    if (const auto numbers = planes_ * rows_ * kept_ * pitch_; numbers_.size() < numbers) numbers_.resize(numbers);
  }

  /// Holds all that a pass reads for a layer: copy(cells, to) has the records `cells` of a row copied, as copy() below
  /// does, for each row that was not there.
  template <int D, class Copy>
  void move_to(const Lattice<D>& lattice, const typename Lattice<D>::Layer& layer, const Copy& copy) {
    const auto* const beam = &lattice.beams()[layer.beam];
    const auto plane = static_cast<std::ptrdiff_t>(layer.plane);
    const auto margin = static_cast<std::ptrdiff_t>(lattice.plane_margin());
    const auto row_margin = static_cast<std::ptrdiff_t>(lattice.row_margin());
    auto from = plane - margin;
    if (beam == beam_) from = std::max(from, next_plane_);
    beam_ = beam;
    next_plane_ = plane + margin + 1;
    row_ = static_cast<std::ptrdiff_t>(beam->row) - row_margin;
    column_ = static_cast<std::ptrdiff_t>(beam->column - lattice.margin());
    const auto last = static_cast<std::ptrdiff_t>(beam->row + beam->rows) + row_margin;
    for (auto p = from; p < next_plane_; ++p)
      for (auto row = row_; row < last; ++row) {
        const auto cells = lattice.row(p, row).subspan(static_cast<std::size_t>(column_));
        copy(cells.first(std::min(pitch_, cells.size())), numbers_.data() + place_of(p, row, column_));
      }
  }

  /// Where a cell stands.
  LatticePlace place(std::size_t plane, std::size_t row, std::size_t column) const {
    return place_of(static_cast<std::ptrdiff_t>(plane), static_cast<std::ptrdiff_t>(row),
                    static_cast<std::ptrdiff_t>(column));
  }
  /// The ways from a cell of this plane to those of its neighbours.
  template <class Neighbours>
  void find_ways(std::size_t plane, const Neighbours& neighbours, std::vector<std::ptrdiff_t>& ways) const {
    const auto here = static_cast<std::ptrdiff_t>(plane);
    ways.clear();
    for (const auto& n : neighbours)
      ways.push_back(place_of(here + n.planes(), row_ + n.rows(), column_ + n.columns()) -
                     place_of(here, row_, column_));
  }

  /// Copies the first `numbers` numbers of the records `cells` of a row; `to` is where the first number of the first
  /// cell stands. Where there is nobody, those of an empty record.
  template <class Record>
  void copy(std::span<const std::uint32_t> cells, const Record* records, std::size_t numbers, double* to) const {
    static const Record nobody{};
    for (std::size_t column = 0; column < cells.size(); column += pack_width) {
      const double* place[pack_width];
      for (std::size_t lane = 0; lane < pack_width; ++lane) {
        const auto i = cells[column + lane];
        place[lane] = reinterpret_cast<const double*>(i != no_record ? &records[i] : &nobody);
        if (const auto next = column + ahead + lane; next < cells.size() && cells[next] != no_record)
          fetch(&records[cells[next]]);
      }
      turn(place, numbers, to + column);
    }
  }

  /// The view of records that stand behind the first `from` numbers of each cell.
  template <class Record>
  Transposed<Record> view(std::size_t from) const {
    return {numbers_.data() + from * pitch_, static_cast<std::ptrdiff_t>(pitch_)};
  }
  std::size_t pitch() const { return pitch_; }
  std::size_t memory() const { return numbers_.capacity() * sizeof(double); }

 private:
  static constexpr std::uint32_t no_record = Lattice<1>::nobody;

  /// Records that are copied soon: they stand in memory as the particles do, not as the cells, and the processor does
  /// not see which comes next.
  static constexpr std::size_t ahead = 2 * pack_width;
  template <class Record>
  static void fetch(const Record* record) {
    const auto* const first = reinterpret_cast<const char*>(record);
    for (std::size_t byte = 0; byte < sizeof(Record); byte += 64) __builtin_prefetch(first + byte);
  }

  LatticePlace place_of(std::ptrdiff_t plane, std::ptrdiff_t row, std::ptrdiff_t column) const {
    const auto planes = static_cast<std::ptrdiff_t>(planes_), rows = static_cast<std::ptrdiff_t>(rows_);
    const auto slot = (plane + planes) % planes;  // planes ahead of the first one are less than that
    return (slot * rows + row - row_) * static_cast<std::ptrdiff_t>(pitch_ * kept_) + column - column_;
  }

  /// Turns pack_width records.
  void turn(const double* (&place)[pack_width], std::size_t numbers, double* to) const {
    std::size_t k = 0;
    for (; k + pack_width <= numbers; k += pack_width) {
      Pack turned[pack_width];
      gather<1>(place, turned);
      for (const auto& number : turned) {
        number.copy_to(to, std::experimental::element_aligned);
        to += pitch_;
      }
      for (auto& next : place) next += pack_width;
    }
    for (std::size_t m = 0; k < numbers; ++k, ++m, to += pitch_)
      for (std::size_t lane = 0; lane < pack_width; ++lane) to[lane] = place[lane][m];
  }

  std::size_t planes_ = 0, rows_ = 0;  ///< of the window, with what is read around a beam
  std::size_t pitch_ = 0;              ///< cells of a row of it
  std::size_t kept_ = 0;               ///< numbers of a cell
  const void* beam_ = nullptr;
  std::ptrdiff_t next_plane_ = 0;        ///< behind the last one that it holds
  std::ptrdiff_t row_ = 0, column_ = 0;  ///< its first ones
  std::vector<double> numbers_;
};

}  // namespace tektite
