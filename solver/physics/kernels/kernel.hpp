#pragma once
// Smoothing kernels W(r, h) = σ_D / h^D w(r/h). A kernel gives its support in units of h, the constant σ_D, the shape
// w(q) and w'(q)/q, which is finite at q = 0 for every kernel here, so that ∇W = σ_D / h^(D+2) w'(q)/q x_ij needs no
// division by r.

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "physics/kernels/cubic_spline.hpp"
#include "physics/kernels/truncated_gaussian.hpp"
#include "physics/kernels/wendland_c2.hpp"

namespace tektite {

using Kernel = std::variant<CubicSpline, WendlandC2, TruncatedGaussian>;

template <class K, int D>
constexpr double kernel_constant(double h) {
  double power = 1.0;
  for (int k = 0; k < D; ++k) power *= h;
  return K::template normalisation<D>() / power;
}

/// W(r, h) in 1/m^D.
template <class K, int D>
double kernel_value(double r, double h) {
  const double q = r / h;
  return q < K::support ? kernel_constant<K, D>(h) * K::shape(q) : 0.0;
}

/// dW/dr (r, h) in 1/m^(D+1).
template <class K, int D>
double kernel_slope(double r, double h) {
  const double q = r / h;
  return q < K::support ? kernel_constant<K, D>(h) / h * q * K::slope_over_q(q) : 0.0;
}

}  // namespace tektite
