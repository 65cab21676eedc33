#pragma once
// Records of a lattice, row by row, and in a row number by number: the k-th number of all its cells, then the next one.
// A pass reads a member of wide_pack_width cells side by side with one load a number, by the names that it uses for
// records that it gathers. All that it reads of the few rows near a particle then lies on a few pages of memory.

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

/// Owns the numbers of all kinds of records of a lattice, so that those of a cell lie near each other.
class TransposedRecords {
 public:
  /// `kept`: numbers of a cell.
  template <int D>
  TransposedRecords(const Lattice<D>& lattice, std::size_t kept)
      : pitch_(lattice.pitch()), kept_(kept), numbers_(kept * lattice.records().size(), 0.0) {}

  /// The way in numbers from a cell to that so many rows and columns on.
  LatticePlace way(std::ptrdiff_t rows, std::ptrdiff_t columns) const {
    return rows * static_cast<std::ptrdiff_t>(pitch_ * kept_) + columns;
  }
  /// The place of a cell, counted row by row.
  LatticePlace place(std::size_t cell) const {
    return way(static_cast<std::ptrdiff_t>(cell / pitch_), static_cast<std::ptrdiff_t>(cell % pitch_));
  }

  /// Every cell holds the first `numbers` numbers of a record of no particle behind its first `from` numbers.
  template <class Record>
  void empty(std::size_t from, std::size_t numbers) {
    const Record nobody{};
    const auto* const number = reinterpret_cast<const double*>(&nobody);
    for (std::size_t row = 0; row < numbers_.size(); row += kept_ * pitch_)
      for (std::size_t k = 0; k < numbers; ++k) std::fill_n(&numbers_[row + (from + k) * pitch_], pitch_, number[k]);
  }

  /// Copies the first `numbers` numbers of the record of every cell that holds one behind the cell's first `from`
  /// numbers; all others stay as they are.
  template <int D, class Record>
  void fill(const Lattice<D>& lattice, const std::vector<Record>& records, std::size_t from, std::size_t numbers) {
    static const Record nobody{};
    for_each(lattice.rows(), [&](std::size_t row) {
      const auto cells = lattice.records().subspan(row * pitch_, pitch_);
      double* const to = numbers_.data() + (row * kept_ + from) * pitch_;
      for (std::size_t column = 0; column < pitch_; column += pack_width) {
        const double* place[pack_width];
        bool any = false;
        for (std::size_t lane = 0; lane < pack_width; ++lane) {
          const auto i = cells[column + lane];
          any = any || i != lattice.nobody;
          place[lane] = reinterpret_cast<const double*>(i != lattice.nobody ? &records[i] : &nobody);
        }
        if (any) copy(place, numbers, to + column);
      }
    });
  }

  /// The view of records that stand behind the first `from` numbers of each cell.
  template <class Record>
  Transposed<Record> view(std::size_t from) const {
    return {numbers_.data() + from * pitch_, static_cast<std::ptrdiff_t>(pitch_)};
  }
  std::size_t memory() const { return numbers_.capacity() * sizeof(double); }

 private:
  /// Turns pack_width records.
  void copy(const double* (&place)[pack_width], std::size_t numbers, double* to) const {
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

  std::size_t pitch_, kept_;
  std::vector<double> numbers_;
};

}  // namespace tektite
