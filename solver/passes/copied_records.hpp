#pragma once
// Which numbers of the records a sweep over a lattice copies, and in which order they stand in a cell.

#include <span>

#include "passes/lagrangian_sums.hpp"
#include "passes/transposed.hpp"

namespace tektite {

/// Of the reference record the volume alone, since pairs know the rest; of the stress record all but J; of others
/// everything. None of records that there are not.
template <int D>
class CopiedRecords {
 public:
  explicit CopiedRecords(const ListedRecords<D>& records) : from_(records) {}

  std::size_t numbers() const {
    std::size_t numbers = 0;
    for_each_kind([&](const auto*, std::size_t count, auto) { numbers += count; });
    return numbers;
  }

  /// Those of the records `cells` of a row, which stands at `to`.
  void copy(const TransposedWindow& window, std::span<const std::uint32_t> cells, double* to) const {
    for_each_kind([&](const auto* records, std::size_t count, auto) {
      window.copy(cells, records, count, to);
      to += count * window.pitch();
    });
  }

  LatticeRecords<D> views(const TransposedWindow& window) const {
    LatticeRecords<D> views{};
    std::size_t before = 0;
    for_each_kind([&]<class Record>(const Record*, std::size_t count, auto view) {
      views.*view = window.template view<Record>(before);
      before += count;
    });
    return views;
  }

 private:
  template <class Record>
  static constexpr std::size_t all_of = sizeof(Record) / sizeof(double);

  /// use(records, how many numbers of each are copied, the member that views them).
  template <class Use>
  void for_each_kind(const Use& use) const {
    if (from_.reference) use(from_.reference, std::size_t{1}, &LatticeRecords<D>::reference);
    if (from_.motion) use(from_.motion, all_of<MotionRecord<D>>, &LatticeRecords<D>::motion);
    if (from_.stress) use(from_.stress, all_of<StressRecord<D>> - 1, &LatticeRecords<D>::stress);
    if (from_.shift) use(from_.shift, all_of<ShiftRecord<D>>, &LatticeRecords<D>::shift);
    if (from_.hourglass) use(from_.hourglass, all_of<HourglassRecord<D>>, &LatticeRecords<D>::hourglass);
    if (from_.strain_rate) use(from_.strain_rate, all_of<StrainRateRecord<D>>, &LatticeRecords<D>::strain_rate);
  }

  ListedRecords<D> from_;
};

}  // namespace tektite
