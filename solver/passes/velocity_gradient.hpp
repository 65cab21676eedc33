#pragma once

#include <cstdint>

#include "passes/far.hpp"
#include "passes/godunov_records.hpp"
#include "passes/pair_gradients.hpp"

namespace tektite {

/// L = Σ V_j (v_j - v_i) ⊗ ∇W, of the particle's own gradients where they are corrected.
template <class Kernel, class Smoothing, int D, class Gradients = PlainGradients<D>>
struct VelocityGradient {
  const DeviatoricRecord<D>* records;
  Smoothing smoothing;
  Tensor<double, D>* velocity_gradient;
  Gradients gradients = {};

  struct Self {
    Vector<Pack, D> x, v;
    Pack h;
    typename Gradients::Self gradients;
  };
  struct Sums {
    Tensor<Pack, D> gradient = Tensor<Pack, D>::zero();
  };

  Self begin(std::size_t i) const {
    return {broadcast(records[i].x), broadcast(records[i].v), records[i].smoothing_length, gradients.begin(i)};
  }

  bool far(const Self& a, const std::uint32_t* j) const { return all_far<Kernel>(a, records, j, smoothing); }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    constexpr int stresses = DeviatoricRecord<D>::stresses;
    const auto other = gather_records<2 * D + stresses + 4>(records, j);
    const Pack* const b = other.number;
    const Pack* const rest = b + 2 * D + stresses;
    Vector<Pack, D> x, v;
    for (int k = 0; k < D; ++k) {
      x[k] = a.x[k] - b[k];
      v[k] = b[D + k] - a.v[k];
    }
    const Pack h = smoothing.of_pair(a.h, rest[3]);
    if constexpr (Gradients::corrected) {
      const auto pair = gradients.of_pair(a.gradients, j, x, h);
      for (int i = 0; i < D; ++i)
        for (int k = 0; k < D; ++k) sums.gradient(i, k) += rest[0] * v[i] * pair.own[k];
    } else {
      const PairAxis<Kernel, D> pair(x, smoothing.inverse_of(h));
      const Pack weight = rest[0] * pair.slope;
      for (int i = 0; i < D; ++i)
        for (int k = 0; k < D; ++k) sums.gradient(i, k) += weight * v[i] * pair.e[k];
    }
  }

  void end(std::size_t i, const Sums& sums) const {
    for (int k = 0; k < D * D; ++k) velocity_gradient[i].c[k] = sum(sums.gradient.c[k]);
  }
};

}  // namespace tektite
