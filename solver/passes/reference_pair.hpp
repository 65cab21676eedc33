#pragma once

#include "core/pack.hpp"
#include "core/tensor.hpp"

namespace tektite {

/// Tensor times vector.
template <class T, int D>
Vector<T, D> times(const Tensor<T, D>& a, const Vector<T, D>& v) {
  Vector<T, D> result;
  for (int i = 0; i < D; ++i) {
    result[i] = a(i, 0) * v[0];
    for (int j = 1; j < D; ++j) result[i] += a(i, j) * v[j];
  }
  return result;
}

/// Mixed kernel-and-gradient correction of a particle, Young et al. (2021), eq. 3-5: with S = Σ V W and g = Σ V ∇W,
///   ∇̃W̃ = K (∇W - (g/S) W)/S
/// `matrix` holds K/S and `shift` holds g/S. Without correction they are the unit tensor and zero.
template <class T, int D>
struct Correction {
  Tensor<T, D> matrix;
  Vector<T, D> shift;

  Vector<T, D> gradient(const Vector<T, D>& plain, const T& value) const {
    Vector<T, D> shifted;
    for (int k = 0; k < D; ++k) shifted[k] = plain[k] - shift[k] * value;
    return times(matrix, shifted);
  }
};

/// Kernel and gradient between two places of the reference configuration; h in m.
template <class Kernel, int D>
struct ReferencePair {
  Pack value;             ///< W
  Vector<Pack, D> slope;  ///< ∇W at the first, along X_a - X_b

  ReferencePair(const Vector<Pack, D>& x, const Pack& h) {
    using std::experimental::sqrt;
    const Pack one_over_h = Pack(1.0) / h;
    const Pack q = sqrt(dot(x, x)) * one_over_h;
    Pack constant = Pack(Kernel::template normalisation<D>());
    for (int k = 0; k < D; ++k) constant *= one_over_h;
    const auto near = q < Pack(Kernel::support);
    value = select(near, constant * Kernel::shape(q), Pack(0.0));
    const Pack factor = select(near, constant * one_over_h * one_over_h * Kernel::slope_over_q(q), Pack(0.0));
    for (int k = 0; k < D; ++k) slope[k] = factor * x[k];
  }
};

/// Lanes that hold a neighbour and not the particle itself, which fills a list up; a sum over kernel values needs it.
template <int D>
Pack is_other(const Vector<Pack, D>& x) {
  return select(dot(x, x) > Pack(0.0), Pack(1.0), Pack(0.0));
}

}  // namespace tektite
