#pragma once
// Records of a lattice, number by number: the k-th number of all cells, then the next one. A pass reads a member of
// pack_width cells side by side with one load a number, by the names that it uses for records that it gathers.

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
  std::size_t cells;
};

/// number(record), a reference to one, of the cells from this one on.
template <class Record, class Number>
[[gnu::always_inline]] inline Pack gathered_by(const Transposed<Record>& t, std::size_t cell, const Number& number) {
  static constexpr Record any{};
  const auto k = static_cast<std::size_t>(&number(any) - reinterpret_cast<const double*>(&any));
  return Pack(t.numbers + k * t.cells + cell, std::experimental::element_aligned);
}

/// A member of the particles themselves, each in its lane.
template <class Record, class Owner, class Member>
[[gnu::always_inline]] inline auto own(const Transposed<Record>& t, std::size_t cell, Member Owner::*member) {
  return gathered(t, cell, member);
}

/// Owns them.
template <class Record>
class TransposedRecords {
 public:
  static constexpr std::size_t all = sizeof(Record) / sizeof(double);

  /// A whole number of packs of cells; only the first `numbers` of each record are kept and may be read.
  explicit TransposedRecords(std::size_t cells, std::size_t numbers = all)
      : cells_(cells), kept_(numbers), numbers_(numbers * cells, 0.0) {}

  /// Copies the record of every cell that holds one; all others stay zero.
  void fill(std::span<const std::uint32_t> record_of_cell, const std::vector<Record>& records) {
    static const Record nobody{};
    for_each(cells_ / pack_width, [&](std::size_t n) {
      const std::size_t cell = n * pack_width;
      const double* place[pack_width];
      bool any = false;
      for (std::size_t lane = 0; lane < pack_width; ++lane) {
        const auto i = record_of_cell[cell + lane];
        any = any || i != Lattice<1>::nobody;
        place[lane] = reinterpret_cast<const double*>(i != Lattice<1>::nobody ? &records[i] : &nobody);
      }
      if (!any) return;
      std::size_t k = 0;
      for (; k + pack_width <= kept_; k += pack_width) {
        Pack turned[pack_width];
        gather<1>(place, turned);
        for (std::size_t m = 0; m < pack_width; ++m) turned[m].copy_to(to(k + m, cell), whole);
        for (auto& next : place) next += pack_width;
      }
      for (std::size_t m = 0; k < kept_; ++k, ++m)
        for (std::size_t lane = 0; lane < pack_width; ++lane) to(k, cell)[lane] = place[lane][m];
    });
  }

  Transposed<Record> view() const { return {numbers_.data(), cells_}; }
  std::size_t memory() const { return numbers_.capacity() * sizeof(double); }

 private:
  static constexpr auto whole = std::experimental::element_aligned;
  double* to(std::size_t number, std::size_t cell) { return numbers_.data() + number * cells_ + cell; }

  std::size_t cells_, kept_;
  std::vector<double> numbers_;
};

}  // namespace tektite
