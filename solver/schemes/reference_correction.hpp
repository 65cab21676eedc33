#pragma once
// The mixed correction in the reference configuration, for those who are in its sums.

#include <cstdint>
#include <vector>

#include "parallel/for_each.hpp"
#include "passes/lagrangian_records.hpp"
#include "schemes/mixed_correction.hpp"

namespace tektite {

template <class Kernel, int D>
class ReferenceCorrection {
 public:
  /// Of the first `count` records, each with its neighbours in `pairs`. Whoever has no volume, or an Eulerian kernel,
  /// is not counted among those without correction.
  void find(const PairList& pairs, const Mirror<D>& mirror, const std::vector<ReferenceRecord<D>>& reference,
            std::size_t count, double least_moment, const Owned& owned) {
    std::vector<CorrectionRecord<D>> records(reference.size());
    for_each(records.size(), [&](std::size_t i) {
      const auto& r = reference[i];
      records[i] = {r.x, r.volume, r.smoothing_length, Correction<double, D>::none()};
    });
    std::vector<std::uint8_t> counted(count);
    for_each(count, [&](std::size_t i) { counted[i] = reference[i].lagrangian != 0.0 && reference[i].volume != 0.0; });
    MixedCorrection<Kernel, D> correction(least_moment);
    without_ = correction.find(pairs, mirror, records, count, counted.data(), owned);
    corrections_.resize(count);
    has_.resize(count);
    for_each(count, [&](std::size_t i) {
      corrections_[i] = records[i].correction;
      has_[i] = correction.has(i);
    });
  }

  const Correction<double, D>* data() const { return corrections_.data(); }
  Correction<double, D>& operator[](std::size_t i) { return corrections_[i]; }
  std::size_t count() const { return corrections_.size(); }
  /// Whether a particle is corrected at all.
  bool has(std::size_t i) const { return has_[i] != 0; }
  /// How many of the own particles go without.
  std::size_t without() const { return without_; }
  std::size_t memory() const { return corrections_.capacity() * sizeof(Correction<double, D>) + has_.capacity(); }

 private:
  std::vector<Correction<double, D>> corrections_;
  std::vector<std::uint8_t> has_;  ///< a byte each
  std::size_t without_ = 0;
};

}  // namespace tektite
