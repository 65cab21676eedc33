#pragma once

#include <algorithm>
#include <cmath>

#include "core/tensor.hpp"
#include "passes/lagrangian_records.hpp"

namespace tektite {

/// The smallest principal stretch of F, at most 1: by it the distances over which the gradients of the reference
/// configuration act have shrunk, and with them the stable time step. It is the inverse root of the largest eigenvalue
/// of F⁻¹F⁻ᵀ = CᵀC/J², for which its mean and its deviator give a bound that does not depend on how a body has turned:
/// mean + √((D-1)/D) |deviator|, exact in the line and in the plane.
template <int D>
double least_stretch(const Tensor<double, D>& cofactor, double jacobian) {
  double trace = 0.0, square = 0.0;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      double product = 0.0;
      for (int k = 0; k < D; ++k) product += cofactor(k, i) * cofactor(k, j);
      square += product * product;
      if (i == j) trace += product;
    }
  const double mean = trace / D;
  const double deviator = std::max(0.0, square - D * mean * mean);
  const double largest = (mean + std::sqrt(deviator * (D - 1) / D)) / (jacobian * jacobian);
  return 1.0 / std::sqrt(std::max(1.0, largest));
}

/// The same of every particle whose kernel is of the reference configuration, 1 of the others. The viscosity's h
/// shrinks with it, but where bodies have Eulerian particles too: these would see another Π than they are seen with.
template <int D>
struct FindLeastStretch {
  const ReferenceRecord<D>* reference;
  StressRecord<D>* records;
  double* least;
  bool shrinks;  ///< the viscosity's h

  void operator()(std::size_t i) const {
    auto& r = records[i];
    least[i] = reference[i].lagrangian != 0.0 ? least_stretch(r.cofactor, r.jacobian) : 1.0;
    r.least_stretch = shrinks ? least[i] : 1.0;
  }
};

}  // namespace tektite
