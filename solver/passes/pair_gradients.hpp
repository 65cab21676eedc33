#pragma once
// The gradients of a pair in the sums of the time-split Godunov scheme: plain, or with the mixed correction.

#include <cstdint>

#include "passes/corrected_rates.hpp"
#include "passes/correction.hpp"
#include "passes/kernel_pair.hpp"

namespace tektite {

/// Without correction: ∇_iW = -∇_jW, along the line between both.
template <int D>
struct PlainGradients {
  static constexpr bool corrected = false;
  struct Self {};

  Self begin(std::size_t) const { return {}; }
};

/// With it: ∇̃_iW̃_ij and ∇̃_jW̃_ji, whose difference is antisymmetric in i and j.
template <class Kernel, int D>
struct CorrectedGradients {
  static constexpr bool corrected = true;
  using Self = Correction<Pack, D>;
  struct Pair {
    Vector<Pack, D> own, other;
  };

  const CorrectionRecord<D>* records;
  CorrectionSwitch correction_switch;

  Self begin(std::size_t i) const { return broadcast(records[i].correction); }

  /// For x = x_i - x_j; equal where a list that is filled up has i itself.
  Pair of_pair(const Self& a, const std::uint32_t* j, const Vector<Pack, D>& x, const Pack& h) const {
    const KernelPair<Kernel, D> pair(x, h);
    const auto minus = Pack(-1.0) * pair.slope;
    const auto b = gathered(records, j, &CorrectionRecord<D>::correction);
    return {correction_switch.choose<D>(a.gradient(pair.slope, pair.value), pair.slope, x, h),
            correction_switch.choose<D>(b.gradient(minus, pair.value), minus, x, h)};
  }
};

}  // namespace tektite
