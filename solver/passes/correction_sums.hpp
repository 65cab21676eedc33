#pragma once

#include <cstdint>

#include "core/pack.hpp"
#include "core/tensor.hpp"
#include "passes/correction.hpp"
#include "passes/kernel_pair.hpp"

namespace tektite {

/// Sums from which the mixed correction follows (Young et al. 2021, eq. 3-5): S = Σ V W, itself included (on a symmetry
/// plane with its image, which is no neighbour but the other half of it), and g = Σ V ∇W; then, with these, M = Σ V (∇W
/// - (g/S) W)/S ⊗ (x_b - x_a), whose inverse is K. A record has the members x, volume, smoothing_length and correction,
/// of the reference configuration or of the present one.
template <class Kernel, int D, class Record>
struct CorrectionSums {
  const Record* records;
  bool second;  ///< S and g are known (in `correction`), M is wanted
  double* kernel_sum;
  double* neighbours;  ///< how many there are within the support
  Vector<double, D>* gradient_sum;
  Tensor<double, D>* moment;

  struct Self {
    std::size_t i;
    Vector<Pack, D> x;
    Pack h;
    Correction<Pack, D> correction;
  };
  struct Sums {
    Pack kernel = 0.0;
    Pack neighbours = 0.0;
    Vector<Pack, D> gradient = Vector<Pack, D>::zero();
    Tensor<Pack, D> moment = Tensor<Pack, D>::zero();
  };

  Self begin(std::size_t i) const {
    const Record& r = records[i];
    return {i, broadcast(r.x), r.smoothing_length, broadcast(r.correction)};
  }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto x = a.x - gathered(records, j, &Record::x);
    const KernelPair<Kernel, D> pair(x, Pack(0.5) * (a.h + gathered(records, j, &Record::smoothing_length)));
    const Pack volume = select(is_other(a.i, j), gathered(records, j, &Record::volume), Pack(0.0));
    sums.kernel += volume * pair.value;
    sums.neighbours += select(pair.value > Pack(0.0), is_other(x), Pack(0.0));
    const auto corrected = a.correction.gradient(pair.slope, pair.value);
    for (int r = 0; r < D; ++r) {
      sums.gradient[r] += volume * pair.slope[r];
      for (int c = 0; c < D; ++c) sums.moment(r, c) -= volume * corrected[r] * x[c];
    }
  }

  void end(std::size_t i, const Sums& sums) const {
    if (records[i].volume == 0.0) return;  // not read by anybody, and so not filled
    if (second) {
      for (int k = 0; k < D * D; ++k) moment[i].c[k] = sum(sums.moment.c[k]);
    } else {
      const double h = records[i].smoothing_length;
      double constant = Kernel::template normalisation<D>();
      for (int k = 0; k < D; ++k) constant /= h;
      kernel_sum[i] = sum(sums.kernel) + records[i].volume * constant * Kernel::shape(0.0);
      neighbours[i] = sum(sums.neighbours);
      for (int k = 0; k < D; ++k) gradient_sum[i][k] = sum(sums.gradient[k]);
    }
  }
};

}  // namespace tektite
