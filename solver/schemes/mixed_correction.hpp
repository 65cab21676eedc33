#pragma once
// The mixed kernel-and-gradient correction of all particles of a list.

#include <fmt/format.h>

#include <string>
#include <vector>

#include "boundary/mirror.hpp"
#include "core/counted.hpp"
#include "parallel/for_each.hpp"
#include "parallel/for_each_pair.hpp"
#include "parallel/reduce.hpp"
#include "passes/correction_sums.hpp"
#include "schemes/scheme.hpp"

namespace tektite {

/// Of the particles of all ranks, those without correction of which each counts its own.
inline std::size_t without_of_all(const Particles& particles, std::size_t own) {
  return over_ranks(particles, own, [](std::size_t& whole, std::size_t part) { whole += part; });
}

/// What a user is told of particles without correction; empty where there are none.
inline std::string remark_on_correction(std::size_t without) {
  if (without == 0) return {};
  return counted(without, "particle") + " without the correction, with too few neighbours for it";
}

/// The failure of a correction that more than this part of the particles goes without.
inline std::vector<Warning> few_neighbours(std::size_t without, std::size_t count) {
  constexpr double notable = 0.01;
  const double part = static_cast<double>(without) / static_cast<double>(count);
  if (part <= notable) return {};
  return {{"few-neighbours",
           fmt::format("{:.0f} % of the particles have too few neighbours for the correction and go without: their "
                       "strains and forces miss what the neighbours would have added; more particles through the "
                       "thinnest part, or a larger smoothing.ratio, may mend it",
                       100.0 * part)}};
}

/// Least determinants of the moment M with which a particle is corrected. M is near the unit tensor in the midst of a
/// body, and has 0.47^D at a corner of a lattice, whatever its h.
///
/// Of the reference configuration of a body that stays whole it is wanted up to the tips of cones: all that can be
/// inverted.
inline constexpr double least_moment_of_reference = 1e-3;
/// Of the present configuration, and where particles fail, those that have less than two thirds of a corner, each way,
/// go without: they are torn off, and gradients several times too large, other ones at each search, tear them further
/// (hvi_2d by `mixed` without the switch C_f ended so, eulerian after 1000 steps and godunov-split after 200).
template <int D>
inline constexpr double least_moment_of_pieces = 0.3 * least_moment_of_pieces<D - 1>;
template <>
inline constexpr double least_moment_of_pieces<0> = 1.0;

template <class Kernel, int D>
class MixedCorrection {
 public:
  /// `least_moment` as above.
  explicit MixedCorrection(double least_moment) : least_moment_(least_moment) {}

  /// Corrections of the first `count` records, from each other and from the images behind them; the records begin with
  /// Correction::none(). A particle with a single neighbour, or with too small a moment, keeps the plain
  /// gradient and is counted by its owner, if `counted` (a byte each, null for all) says so.
  template <class Record>
  std::size_t find(const PairList& pairs, const Mirror<D>& mirror, std::vector<Record>& records, std::size_t count,
                   const std::uint8_t* counted = nullptr, const Owned& owned = {}) {
    without_.assign(count, 1);  // also who has no list
    for_each_pair(pairs, CorrectionSums<Kernel, D, Record>{records.data(), least_moment_, without_.data()});
    const auto tell = [&](std::size_t& without, std::size_t i) {
      without += without_[i] && (!counted || counted[i]) && owned(i);
    };
    const auto without = reduce(count, std::size_t{0}, tell, [](auto& whole, auto part) { whole += part; });
    mirror.fill(records, count);
    return without;
  }
  /// Whether a particle had one at the last find().
  bool has(std::size_t i) const { return without_[i] == 0; }

 private:
  double least_moment_;
  std::vector<std::uint8_t> without_;  ///< a byte each
};

}  // namespace tektite
