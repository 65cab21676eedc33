#pragma once

#include "core/tensor_algebra.hpp"
#include "passes/gathered.hpp"

namespace tektite {

/// Mixed kernel-and-gradient correction of a particle, Young et al. (2021), eq. 3-5: with S = Σ V W and g = Σ V ∇W,
///   ∇̃W̃ = K (∇W - (g/S) W)/S
/// `matrix` holds K/S and `shift` holds g/S. Without correction they are the unit tensor and zero.
template <class T, int D>
struct Correction {
  Tensor<T, D> matrix;
  Vector<T, D> shift;

  static Correction none() {
    Correction c{Tensor<T, D>::zero(), Vector<T, D>::zero()};
    for (int k = 0; k < D; ++k) c.matrix(k, k) = T(1.0);
    return c;
  }

  void mirror(int axis) {
    mirror_tensor(matrix, axis);
    shift[axis] = -shift[axis];
  }

  Vector<T, D> gradient(const Vector<T, D>& plain, const T& value) const {
    Vector<T, D> shifted;
    for (int k = 0; k < D; ++k) shifted[k] = plain[k] - shift[k] * value;
    return times(matrix, shifted);
  }
};

/// What the correction is found from, and where it is kept.
template <int D>
struct CorrectionRecord {
  Vector<double, D> x;      ///< m
  double volume;            ///< m/ρ
  double smoothing_length;  ///< h
  Correction<double, D> correction;

  void mirror(int axis, double at) {
    x[axis] = 2.0 * at - x[axis];
    correction.mirror(axis);
  }
};

template <int D>
[[gnu::always_inline]] inline Correction<Pack, D> broadcast(const Correction<double, D>& c) {
  return {broadcast(c.matrix), broadcast(c.shift)};
}
template <class Records, class Index, class Owner, int D>
[[gnu::always_inline]] inline auto gathered(const Records& records, Index j, Correction<double, D> Owner::*member) {
  Correction<typename NumberOf<Records>::Type, D> result;
  for (int k = 0; k < D * D; ++k)
    result.matrix.c[k] =
        gathered_by(records, j, [=](const Owner& r) -> const double& { return (r.*member).matrix.c[k]; });
  for (int k = 0; k < D; ++k)
    result.shift[k] = gathered_by(records, j, [=](const Owner& r) -> const double& { return (r.*member).shift[k]; });
  return result;
}

/// Stands for a correction where there is none.
template <class T, int D>
struct PlainGradient {
  const Vector<T, D>& gradient(const Vector<T, D>& plain, const T&) const { return plain; }
};

}  // namespace tektite
