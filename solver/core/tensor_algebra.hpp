#pragma once

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

/// det(F)
template <int D>
double determinant(const Tensor<double, D>& f) {
  if constexpr (D == 1)
    return f(0, 0);
  else if constexpr (D == 2)
    return f(0, 0) * f(1, 1) - f(0, 1) * f(1, 0);
  else
    return f(0, 0) * (f(1, 1) * f(2, 2) - f(1, 2) * f(2, 1)) - f(0, 1) * (f(1, 0) * f(2, 2) - f(1, 2) * f(2, 0)) +
           f(0, 2) * (f(1, 0) * f(2, 1) - f(1, 1) * f(2, 0));
}

/// C = det(F) F⁻ᵀ
template <int D>
Tensor<double, D> cofactor(const Tensor<double, D>& f) {
  Tensor<double, D> c;
  if constexpr (D == 1) {
    c(0, 0) = 1.0;
  } else if constexpr (D == 2) {
    c(0, 0) = f(1, 1);
    c(0, 1) = -f(1, 0);
    c(1, 0) = -f(0, 1);
    c(1, 1) = f(0, 0);
  } else {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        c(i, j) = f(i1, j1) * f(i2, j2) - f(i1, j2) * f(i2, j1);
      }
  }
  return c;
}

/// Reflects a tensor at a plane across this axis.
template <int D>
void mirror_tensor(Tensor<double, D>& t, int axis) {
  for (int k = 0; k < D; ++k)
    if (k != axis) {
      t(axis, k) = -t(axis, k);
      t(k, axis) = -t(k, axis);
    }
}

}  // namespace tektite
