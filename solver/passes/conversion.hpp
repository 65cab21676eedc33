#pragma once

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/tensor_algebra.hpp"

namespace tektite {

/// Equivalent strain √(2/3 ε':ε') of the logarithmic strain ε = ½ ln(F Fᵀ), of which nothing is across the space: Young
/// et al. (2021), eq. 18, which leaves the measure open. F has a positive determinant.
template <int D>
double equivalent_strain(const Tensor<double, D>& f) {
  double principal[3] = {0.0, 0.0, 0.0};  // of F Fᵀ, then of ε
  if constexpr (D == 1) {
    principal[0] = f(0, 0) * f(0, 0);
  } else if constexpr (D == 2) {
    const double xx = f(0, 0) * f(0, 0) + f(0, 1) * f(0, 1), yy = f(1, 0) * f(1, 0) + f(1, 1) * f(1, 1);
    const double xy = f(0, 0) * f(1, 0) + f(0, 1) * f(1, 1), j = determinant(f);
    const double half = 0.5 * (xx - yy);
    principal[0] = 0.5 * (xx + yy) + std::sqrt(half * half + xy * xy);
    principal[1] = j * j / principal[0];  // the difference would cancel
  } else {
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> m(f.c);
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(m * m.transpose(), Eigen::EigenvaluesOnly);
    for (int k = 0; k < 3; ++k) principal[k] = solver.eigenvalues()[k];
  }
  double mean = 0.0;
  for (int k = 0; k < D; ++k) mean += principal[k] = 0.5 * std::log(principal[k]);
  mean /= 3.0;
  double square = 0.0;
  for (const double strain : principal) square += (strain - mean) * (strain - mean);
  return std::sqrt(square / 1.5);
}

/// An equivalent strain that is not to be exceeded. Most particles are told to be below it without roots and
/// logarithms: principal logarithmic strains of at most m have an equivalent one of at most 4/3 m, the squares of the
/// principal stretches are below their sum S, and the least of them is above det²/(S/(D-1))^(D-1).
class StrainLimit {
 public:
  explicit StrainLimit(double strain) : strain_(strain), most_(std::exp(1.5 * strain)) {}

  template <int D>
  bool exceeded_by(const Tensor<double, D>& f) const {
    double sum = 0.0, least = determinant(f);
    for (const double component : f.c) sum += component * component;
    least *= least;
    for (int k = 1; k < D; ++k) least *= (D - 1) / sum;
    const bool below = sum <= most_ && least * most_ >= 1.0;
    return !below && equivalent_strain(f) > strain_;
  }

 private:
  double strain_, most_;  ///< and e^(2m)
};

}  // namespace tektite
