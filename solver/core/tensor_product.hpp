#pragma once

#include "core/tensor.hpp"

namespace tektite {

/// a b
template <class T, int D>
Tensor<T, D> product(const Tensor<T, D>& a, const Tensor<T, D>& b) {
  Tensor<T, D> result;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      result(i, j) = a(i, 0) * b(0, j);
      for (int k = 1; k < D; ++k) result(i, j) += a(i, k) * b(k, j);
    }
  return result;
}

template <class T, int D>
Tensor<T, D> transposed(const Tensor<T, D>& a) {
  Tensor<T, D> result;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) result(i, j) = a(j, i);
  return result;
}

/// a bᵀ
template <class T, int D>
Tensor<T, D> product_with_transposed(const Tensor<T, D>& a, const Tensor<T, D>& b) {
  Tensor<T, D> result;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      result(i, j) = a(i, 0) * b(j, 0);
      for (int k = 1; k < D; ++k) result(i, j) += a(i, k) * b(j, k);
    }
  return result;
}

}  // namespace tektite
