#pragma once

#include <cstdint>

#include "core/pack.hpp"
#include "core/tensor.hpp"
#include "passes/correction.hpp"
#include "passes/kernel_pair.hpp"

namespace tektite {

/// The mixed correction (Young et al. 2021, eq. 3-5) from one sum over neighbours: with S = Σ V W, itself included (on
/// a symmetry plane with its image, which is no neighbour but the other half of it), g = Σ V ∇W, and the first moments
/// A = Σ V ∇W ⊗ (x_b - x_a), B = Σ V W (x_b - x_a), what the gradients corrected by S and g make of a linear field is
///   M = Σ V (∇W - (g/S) W)/S ⊗ (x_b - x_a) = (A - (g/S) ⊗ B)/S
/// and K is its inverse. A record has the members x, volume, smoothing_length and correction, of the reference
/// configuration or of the present one; the correction begins with Correction::none() and stays so where the particle
/// has a single neighbour, or less of M's determinant than `least_moment`.
template <class Kernel, int D, class Record>
struct CorrectionSums {
  Record* records;
  double least_moment;
  std::uint8_t* without;  ///< becomes 0 where there is a correction

  struct Self {
    std::size_t i;
    Vector<Pack, D> x;
    Pack h;
  };
  struct Sums {
    Pack kernel = 0.0;
    Pack neighbours = 0.0;
    Vector<Pack, D> gradient = Vector<Pack, D>::zero();
    Vector<Pack, D> kernel_moment = Vector<Pack, D>::zero();
    Tensor<Pack, D> gradient_moment = Tensor<Pack, D>::zero();
  };

  Self begin(std::size_t i) const {
    const Record& r = records[i];
    return {i, broadcast(r.x), r.smoothing_length};
  }

  /// Whether no neighbour in j is within the support. Lists end with packs that hold the skin alone.
  bool far(const Self& a, const std::uint32_t* j) const {
    const Pack h = Pack(0.5) * (a.h + gathered(records, j, &Record::smoothing_length));
    return beyond_support<Kernel>(a.x - gathered(records, j, &Record::x), h, is_other(a.i, j));
  }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto x = a.x - gathered(records, j, &Record::x);
    const KernelPair<Kernel, D> pair(x, Pack(0.5) * (a.h + gathered(records, j, &Record::smoothing_length)));
    const Pack volume = select(is_other(a.i, j), gathered(records, j, &Record::volume), Pack(0.0));
    const Pack weight = volume * pair.value;
    sums.kernel += weight;
    sums.neighbours += select(weight > Pack(0.0), is_other(x), Pack(0.0));
    for (int r = 0; r < D; ++r) {
      const Pack slope = volume * pair.slope[r];
      sums.gradient[r] += slope;
      sums.kernel_moment[r] -= weight * x[r];
      for (int c = 0; c < D; ++c) sums.gradient_moment(r, c) -= slope * x[c];
    }
  }

  void end(std::size_t i, const Sums& sums) const {
    if (records[i].volume == 0.0) return;  // not read by anybody, and so not filled
    const double h = records[i].smoothing_length;
    double constant = Kernel::template normalisation<D>();
    for (int k = 0; k < D; ++k) constant /= h;
    const double s = sum(sums.kernel) + records[i].volume * constant * Kernel::shape(0.0);
    Vector<double, D> shift;
    for (int k = 0; k < D; ++k) shift[k] = sum(sums.gradient[k]) / s;
    Tensor<double, D> moment;
    for (int r = 0; r < D; ++r)
      for (int c = 0; c < D; ++c)
        moment(r, c) = (sum(sums.gradient_moment(r, c)) - shift[r] * sum(sums.kernel_moment[c])) / s;
    const double determinant_of_m = determinant(moment);
    if (!(sum(sums.neighbours) > 1.0 && determinant_of_m > least_moment)) return;
    const auto c = cofactor(moment);
    auto& correction = records[i].correction;
    correction.shift = shift;
    for (int r = 0; r < D; ++r)
      for (int k = 0; k < D; ++k) correction.matrix(r, k) = c(k, r) / determinant_of_m / s;
    without[i] = 0;
  }
};

}  // namespace tektite
