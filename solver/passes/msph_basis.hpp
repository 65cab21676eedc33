#pragma once
// The basis functions of MSPH and SSPH: what multiplies the Taylor expansion, and the coefficients that the inverse of
// the matrix B gives. Lengths are in units of h, so that B is a number and its condition does not depend on units.

#include <Eigen/Dense>

#include "core/pack.hpp"
#include "core/tensor.hpp"
#include "physics/kernels/kernel.hpp"

namespace tektite {

/// Terms of a Taylor expansion of second order in D coordinates: 1, ξ_a, ½ ξ_a², ξ_a ξ_b.
template <int D>
inline constexpr int taylor_terms = (D + 1) * (D + 2) / 2;

template <class T, int D>
using TaylorTerms = Vector<T, taylor_terms<D>>;

/// Θ of Batra and Zhang (2008), eq. 2.4, at ξ = (x_j - x_i)/h.
template <class T, int D>
TaylorTerms<T, D> taylor(const Vector<T, D>& xi) {
  TaylorTerms<T, D> theta;
  int n = 0;
  theta[n++] = T(1.0);
  for (int a = 0; a < D; ++a) theta[n++] = xi[a];
  for (int a = 0; a < D; ++a) theta[n++] = T(0.5) * xi[a] * xi[a];
  for (int a = 0; a < D; ++a)
    for (int b = a + 1; b < D; ++b) theta[n++] = xi[a] * xi[b];
  return theta;
}

/// Φ of eq. 2.4: the kernel of eq. 2.8, its first and its second derivatives in x_i, times h^D, h^(D+1) and h^(D+2)
/// and without the kernel's constant, by which the result does not change.
template <int D>
struct MsphWeights {
  template <class T>
  static TaylorTerms<T, D> at(const Vector<T, D>& xi) {
    const T g = exponential(-dot(xi, xi));
    TaylorTerms<T, D> phi;
    int n = 0;
    phi[n++] = g - T(TruncatedGaussian::cut);
    for (int a = 0; a < D; ++a) phi[n++] = T(2.0) * xi[a] * g;
    for (int a = 0; a < D; ++a) phi[n++] = (T(4.0) * xi[a] * xi[a] - T(2.0)) * g;
    for (int a = 0; a < D; ++a)
      for (int b = a + 1; b < D; ++b) phi[n++] = T(4.0) * xi[a] * xi[b] * g;
    return phi;
  }
};

/// SSPH (section 7): Φ = W Θ, so that B is symmetric and no derivative of the kernel is needed.
template <class Kernel, int D>
struct SsphWeights {
  template <class T>
  static TaylorTerms<T, D> at(const Vector<T, D>& xi) {
    using std::sqrt;
    const T w = Kernel::shape(sqrt(dot(xi, xi)));
    auto phi = taylor(xi);
    for (int n = 0; n < taylor_terms<D>; ++n) phi[n] = w * phi[n];
    return phi;
  }
};

/// What the sums over neighbours multiply Φ with: row r of B⁻¹ gives the function (r = 0), its first derivatives
/// (r = 1 .. D) and its second ones, in powers of h.
template <int D>
struct MsphCoefficients {
  Vector<TaylorTerms<double, D>, taylor_terms<D>> row;
  int order = 2;  ///< of the expansion that B could be inverted for

  /// Reflects them at a plane across `axis`: terms that are odd in it change their sign.
  void mirror(int axis, double) {
    TaylorTerms<double, D> parity;
    int n = 0;
    parity[n++] = 1.0;
    for (int a = 0; a < D; ++a) parity[n++] = a == axis ? -1.0 : 1.0;
    for (int a = 0; a < D; ++a) parity[n++] = 1.0;
    for (int a = 0; a < D; ++a)
      for (int b = a + 1; b < D; ++b) parity[n++] = a == axis || b == axis ? -1.0 : 1.0;
    for (int r = 0; r < taylor_terms<D>; ++r)
      for (int c = 0; c < taylor_terms<D>; ++c) row[r][c] *= parity[r] * parity[c];
  }
};

/// B may be inverted below this condition number (in the 1-norm). Inside a lattice it is 3, on the corner of a
/// disordered one with h = 1.5 spacings 1e3; a hundred times that is a neighbourhood that has lost its shape.
inline constexpr double largest_condition = 1e5;

/// Inverts B by the highest order whose block is well conditioned: 2, 1 or, where a particle is alone, 0.
template <int D>
MsphCoefficients<D> invert_moments(const Eigen::Matrix<double, taylor_terms<D>, taylor_terms<D>>& b) {
  constexpr int N = taylor_terms<D>;
  MsphCoefficients<D> result;
  for (int r = 0; r < N; ++r) result.row[r] = TaylorTerms<double, D>::zero();
  const auto attempt = [&]<int size>(std::integral_constant<int, size>) {
    const Eigen::Matrix<double, size, size> block = b.template topLeftCorner<size, size>();
    const auto factors = block.partialPivLu();
    if (factors.matrixLU().diagonal().cwiseAbs().minCoeff() == 0.0) return false;
    Eigen::Matrix<double, size, size> inverse;  // column by column, which Eigen unrolls
    for (int c = 0; c < size; ++c) inverse.col(c) = factors.solve(Eigen::Matrix<double, size, 1>::Unit(c));
    const double condition =
        block.cwiseAbs().colwise().sum().maxCoeff() * inverse.cwiseAbs().colwise().sum().maxCoeff();
    if (!(condition < largest_condition)) return false;
    for (int r = 0; r < size; ++r)
      for (int c = 0; c < size; ++c) result.row[r][c] = inverse(r, c);
    return true;
  };
  if (attempt(std::integral_constant<int, N>{})) return result;
  result.order = attempt(std::integral_constant<int, D + 1>{}) ? 1 : 0;
  return result;
}

}  // namespace tektite
