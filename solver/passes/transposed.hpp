#pragma once
// Records of a lattice, row by row, and in a row number by number: the k-th number of all its cells, then the next one.
// A pass reads a member of wide_pack_width cells side by side with one load a number, by the names that it uses for
// records that it gathers. All that it reads of the few rows near a particle then lies on a few pages of memory.

#include <span>
#include <vector>

#include "core/pack.hpp"
#include "neighbours/lattice.hpp"
#include "parallel/for_each.hpp"
#include "passes/gathered.hpp"

namespace tektite {

/// What a pass sees of them. Record: a struct of doubles.
template <class Record>
struct Transposed {
  const double* numbers;
  std::size_t pitch;  ///< cells in a row
  std::size_t kept;   ///< numbers of a record
};

template <class Record>
struct NumberOf<Transposed<Record>> {
  using Type = WidePack;
};

/// number(record), a reference to one, of the cells from this one on.
template <class Record, class Number>
[[gnu::always_inline]] inline WidePack gathered_by(const Transposed<Record>& t, const LatticeCell& cell,
                                                   const Number& number) {
  static constexpr Record any{};
  const auto k = static_cast<std::size_t>(&number(any) - reinterpret_cast<const double*>(&any));
  return WidePack(t.numbers + (cell.row * t.kept + k) * t.pitch + cell.column, std::experimental::element_aligned);
}

/// A member of the particles themselves, each in its lane.
template <class Record, class Owner, class Member>
[[gnu::always_inline]] inline auto own(const Transposed<Record>& t, const LatticeCell& cell, Member Owner::*member) {
  return gathered(t, cell, member);
}

/// Owns them.
template <class Record>
class TransposedRecords {
 public:
  static constexpr std::size_t all = sizeof(Record) / sizeof(double);

  /// Only the first `numbers` of each record are kept and may be read.
  template <int D>
  explicit TransposedRecords(const Lattice<D>& lattice, std::size_t numbers = all)
      : pitch_(lattice.pitch()), kept_(numbers), numbers_(numbers * lattice.records().size(), 0.0) {}

  /// Copies the record of every cell that holds one; all others stay zero.
  template <int D>
  void fill(const Lattice<D>& lattice, const std::vector<Record>& records) {
    static const Record nobody{};
    for_each(lattice.rows(), [&](std::size_t row) {
      const auto cells = lattice.records().subspan(row * pitch_, pitch_);
      double* const numbers = numbers_.data() + row * pitch_ * kept_;
      for (std::size_t column = 0; column + pack_width <= pitch_; column += pack_width) {
        const double* place[pack_width];
        bool any = false;
        for (std::size_t lane = 0; lane < pack_width; ++lane) {
          const auto i = cells[column + lane];
          any = any || i != lattice.nobody;
          place[lane] = reinterpret_cast<const double*>(i != lattice.nobody ? &records[i] : &nobody);
        }
        if (any) copy(place, numbers + column);
      }
    });
  }

  Transposed<Record> view() const { return {numbers_.data(), pitch_, kept_}; }
  std::size_t memory() const { return numbers_.capacity() * sizeof(double); }

 private:
  /// Turns pack_width records.
  void copy(const double* (&place)[pack_width], double* to) {
    std::size_t k = 0;
    for (; k + pack_width <= kept_; k += pack_width) {
      Pack turned[pack_width];
      gather<1>(place, turned);
      for (const auto& number : turned) {
        number.copy_to(to, std::experimental::element_aligned);
        to += pitch_;
      }
      for (auto& next : place) next += pack_width;
    }
    for (std::size_t m = 0; k < kept_; ++k, ++m, to += pitch_)
      for (std::size_t lane = 0; lane < pack_width; ++lane) to[lane] = place[lane][m];
  }

  std::size_t pitch_, kept_;
  std::vector<double> numbers_;
};

}  // namespace tektite
