// Small tensors against Eigen's full matrices.
#include "core/tensor.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <random>

using namespace tektite;

namespace {

std::mt19937 generator(1);

double random_number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(generator); }

template <int D>
Symmetric<double, D> random_symmetric() {
  Symmetric<double, D> a;
  for (auto& c : a.c) c = random_number();
  return a;
}

/// All nine components.
template <int D>
Eigen::Matrix3d full(const Symmetric<double, D>& a) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) m(i, i) = a(i, i);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) m(i, j) = a(i, j);
  return m;
}

constexpr double rounding = 1e-14;  // a few additions of numbers below one

template <int D>
void check_symmetric() {
  const auto a = random_symmetric<D>(), b = random_symmetric<D>();
  const Eigen::Matrix3d A = full(a), B = full(b);
  CHECK(A.isApprox(A.transpose(), 0.0));
  CHECK(full(a + b).isApprox(A + B, rounding));
  CHECK(full(a - b).isApprox(A - B, rounding));
  CHECK(full(3.0 * a).isApprox(3.0 * A, rounding));
  CHECK(trace(a) == Approx(A.trace()).margin(rounding));
  CHECK(contract(a, b) == Approx((A.array() * B.array()).sum()).margin(rounding));
  const Eigen::Matrix3d S = A - A.trace() / 3.0 * Eigen::Matrix3d::Identity();
  CHECK(full(deviator(a)).isApprox(S, rounding));
  CHECK(von_mises(deviator(a)) == Approx(std::sqrt(1.5) * S.norm()).epsilon(rounding));

  Vector<double, D> v;
  Eigen::Vector3d V = Eigen::Vector3d::Zero();
  for (int k = 0; k < D; ++k) V[k] = v[k] = random_number();
  const auto product = a * v;
  for (int k = 0; k < D; ++k) CHECK(product[k] == Approx((A * V)[k]).margin(rounding));
}

template <int D>
void check_rate() {
  Tensor<double, D> l;
  Eigen::Matrix3d L = Eigen::Matrix3d::Zero();
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) L(i, j) = l(i, j) = random_number();
  CHECK(trace(l) == Approx(L.trace()).margin(rounding));
  CHECK(full(symmetric_part(l)).isApprox(0.5 * (L + L.transpose()), rounding));
}

}  // namespace

TEST_CASE("Symmetric tensors: the algebra is that of full matrices", "[tensor]") {
  for (int repeat = 0; repeat < 20; ++repeat) {
    check_symmetric<1>();
    check_symmetric<2>();
    check_symmetric<3>();
  }
}

TEST_CASE("Tensors: the rate of deformation is the symmetric part", "[tensor]") {
  for (int repeat = 0; repeat < 20; ++repeat) {
    check_rate<1>();
    check_rate<2>();
    check_rate<3>();
  }
}

TEST_CASE("Tensors: an outer product adds row by column", "[tensor]") {
  auto t = Tensor<double, 2>::zero();
  add_outer(t, {{1.0, 2.0}}, {{10.0, 100.0}});
  add_outer(t, {{1.0, 0.0}}, {{1.0, 0.0}});
  CHECK(t(0, 0) == 11.0);
  CHECK(t(0, 1) == 100.0);
  CHECK(t(1, 0) == 20.0);
  CHECK(t(1, 1) == 200.0);
}

TEST_CASE("Symmetric tensors: each component has a place of its own", "[tensor]") {
  auto a = Symmetric<double, 3>::zero();
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) a(i, j) = 10.0 * (i + 1) + (j + 1);
  CHECK(std::vector<double>(a.c, a.c + 6) == std::vector<double>{11.0, 22.0, 33.0, 12.0, 23.0, 13.0});
}

TEST_CASE("Von Mises: uniaxial tension is its own equivalent", "[tensor]") {
  const Symmetric<double, 1> tension{{3e8, 0.0, 0.0}};
  CHECK(von_mises(deviator(tension)) == Approx(3e8).epsilon(rounding));
}
