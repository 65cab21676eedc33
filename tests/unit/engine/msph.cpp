// MSPH and SSPH: value, first and second derivatives of a quadratic field are exact, on disordered particles with
// different volumes and up to the edge of the body; where B is ill-conditioned, a lower order answers.
#include <catch2/catch.hpp>
#include <cfenv>
#include <random>

#include "parallel/for_each_pair.hpp"
#include "passes/msph_adjoint.hpp"
#include "passes/msph_motion.hpp"

using namespace tektite;

namespace {

constexpr double spacing = 1e-3;  // m

/// A lattice of `side` particles along each axis, each moved by up to a fifth of the spacing and with a volume of its
/// own.
template <int D>
std::vector<EulerianRecord<D>> disordered(int side, double ratio) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2), size(0.5, 1.5);
  std::vector<EulerianRecord<D>> records;
  const int count = D == 1 ? side : D == 2 ? side * side : side * side * side;
  for (int n = 0; n < count; ++n) {
    EulerianRecord<D> r{};
    for (int k = 0, rest = n; k < D; ++k, rest /= side) r.x[k] = spacing * (rest % side + jitter(generator));
    r.volume = std::pow(spacing, D) * size(generator);
    r.density = 1000.0;
    r.smoothing_length = ratio * spacing;
    records.push_back(r);
  }
  return records;
}

template <int D>
PairList pairs_of(const std::vector<EulerianRecord<D>>& records, double reach) {
  std::vector<Vector<double, D>> places;
  for (const auto& r : records) places.push_back(r.x);
  CellGrid<D> grid;
  grid.build(places, reach);
  const std::vector<std::uint32_t> body(records.size(), 0);
  PairList pairs;
  pairs.build<D>(grid, places, places.size(), reach, Pairing::all, body);
  return pairs;
}

template <class Weights, class Kernel, int D>
std::vector<MsphCoefficients<D>> coefficients_of(const std::vector<EulerianRecord<D>>& records, const PairList& pairs) {
  std::vector<MsphCoefficients<D>> coefficients(records.size());
  std::vector<double> mass(records.size());
  std::vector<Vector<double, D>> lopsidedness(records.size());
  for_each_pair(pairs, MsphMoments<Weights, Kernel, D, 0>{
                           {records.data()}, coefficients.data(), mass.data(), lopsidedness.data()});
  return coefficients;
}

/// F of eq. 2.5 at a particle: derivatives of f in units of 1, h and h², for f given at the places of all particles.
template <class Weights, int D>
TaylorTerms<double, D> derivatives(const std::vector<EulerianRecord<D>>& records, const MsphCoefficients<D>& c,
                                   std::size_t i, const std::vector<double>& f) {
  auto t = TaylorTerms<double, D>::zero();
  const auto& own = records[i];
  for (std::size_t j = 0; j < records.size(); ++j) {
    const auto xi = (1.0 / own.smoothing_length) * (records[j].x - own.x);
    if (dot(xi, xi) < 4.0) t += (records[j].volume / own.volume * f[j]) * Weights::at(xi);
  }
  TaylorTerms<double, D> result;
  for (int r = 0; r < taylor_terms<D>; ++r) result[r] = dot(c.row[r], t);
  return result;
}

template <class Weights, class Kernel, int D>
void check_quadratic(int side, double ratio) {
  INFO(D << " coordinates");
  const auto records = disordered<D>(side, ratio);
  const double h = ratio * spacing;
  const auto pairs = pairs_of<D>(records, 2.0 * h);
  const auto coefficients = coefficients_of<Weights, Kernel, D>(records, pairs);
  TaylorTerms<double, D> a;  // of the field, in units of the spacing
  for (int n = 0; n < taylor_terms<D>; ++n) a[n] = 1.0 + 0.37 * n;
  std::vector<double> f;
  for (const auto& r : records) f.push_back(dot(a, taylor((1.0 / h) * r.x)));
  // B's condition number is of order 1e3 here, so that round-off stays under 1e-11 of the field's values (up to 1e3).
  constexpr double round_off = 1e-8;
  for (std::size_t i = 0; i < records.size(); ++i) {
    REQUIRE(coefficients[i].order == 2);
    const auto found = derivatives<Weights, D>(records, coefficients[i], i, f);
    const auto xi = (1.0 / h) * records[i].x;
    CHECK(found[0] == Approx(f[i]).margin(round_off));
    int mixed = 2 * D + 1;
    for (int k = 0; k < D; ++k) {
      double slope = a[1 + k] + a[1 + D + k] * xi[k];
      for (int b = 0, n = 2 * D + 1; b < D; ++b)
        for (int c = b + 1; c < D; ++c, ++n) slope += b == k ? a[n] * xi[c] : c == k ? a[n] * xi[b] : 0.0;
      CHECK(found[1 + k] == Approx(slope).margin(round_off));
      CHECK(found[1 + D + k] == Approx(a[1 + D + k]).margin(round_off));
    }
    for (; mixed < taylor_terms<D>; ++mixed) CHECK(found[mixed] == Approx(a[mixed]).margin(round_off));
  }
}

}  // namespace

TEST_CASE("MSPH: a quadratic field and its derivatives are exact up to the edge", "[msph]") {
  check_quadratic<MsphWeights<1>, TruncatedGaussian, 1>(30, 1.8);
  check_quadratic<MsphWeights<2>, TruncatedGaussian, 2>(12, 1.8);
  check_quadratic<MsphWeights<3>, TruncatedGaussian, 3>(6, 1.8);
}

TEST_CASE("SSPH: a quadratic field and its derivatives are exact for every kernel", "[msph]") {
  check_quadratic<SsphWeights<CubicSpline, 1>, CubicSpline, 1>(30, 1.8);
  check_quadratic<SsphWeights<CubicSpline, 2>, CubicSpline, 2>(12, 1.8);
  check_quadratic<SsphWeights<WendlandC2, 2>, WendlandC2, 2>(12, 1.8);
  check_quadratic<SsphWeights<TruncatedGaussian, 3>, TruncatedGaussian, 3>(6, 1.8);
}

TEST_CASE("MSPH: the sums of the scheme give the gradient and the value of a quadratic velocity", "[msph]") {
  auto records = disordered<2>(12, 1.8);
  for (auto& r : records) {
    const double x = r.x[0] / spacing, y = r.x[1] / spacing;
    r.v = {{1.0 + 2.0 * x - y + 0.5 * x * x + x * y, 3.0 * y - x + 0.25 * y * y}};
  }
  const auto pairs = pairs_of<2>(records, 3.6 * spacing);
  const auto coefficients = coefficients_of<MsphWeights<2>, TruncatedGaussian, 2>(records, pairs);
  std::vector<Tensor<double, 2>> gradient(records.size());
  std::vector<Vector<double, 2>> fitted(records.size());
  for_each_pair(pairs,
                MsphVelocity<MsphWeights<2>, 2>{{records.data()}, coefficients.data(), gradient.data(), fitted.data()});
  for (std::size_t i = 0; i < records.size(); ++i) {
    const double x = records[i].x[0] / spacing, y = records[i].x[1] / spacing;
    CHECK(spacing * gradient[i](0, 0) == Approx(2.0 + x + y).margin(1e-9));
    CHECK(spacing * gradient[i](0, 1) == Approx(-1.0 + x).margin(1e-9));
    CHECK(spacing * gradient[i](1, 0) == Approx(-1.0).margin(1e-9));
    CHECK(spacing * gradient[i](1, 1) == Approx(3.0 + 0.5 * y).margin(1e-9));
    CHECK(fitted[i][0] == Approx(records[i].v[0]).margin(1e-9));
  }
}

namespace {

/// With random stresses and velocities, what the adjoint forces do is what the strain rates take; and a common velocity
/// is not felt.
template <class Weights, class Kernel, int D, int hoops>
void check_adjoint() {
  INFO(D << " coordinates, " << hoops << " directions across");
  auto records = disordered<D>(D == 3 ? 6 : 12, 1.8);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::vector<double> across;
  for (auto& r : records) {
    r.x[0] += 30.0 * spacing;  // away from the axis
    r.smoothing_length *= 1.0 + 0.05 * any(generator);
    for (auto& s : r.stress) s = any(generator);
    for (int k = 0; k < D; ++k) r.v[k] = any(generator);
    across.push_back(any(generator));
  }
  const auto pairs = pairs_of<D>(records, 4.0 * spacing);
  const auto c = coefficients_of<Weights, Kernel, D>(records, pairs);
  std::vector<Tensor<double, D>> gradient(records.size());
  std::vector<Vector<double, D>> fitted(records.size()), force(records.size());
  for_each_pair(pairs, MsphVelocity<Weights, D>{{records.data()}, c.data(), gradient.data(), fitted.data()});
  for_each_pair(pairs, MsphAdjoint<Weights, D, hoops>{{records.data()}, c.data(), across.data(), force.data()});
  double work = 0.0, power = 0.0, size = 0.0;
  auto whole = Vector<double, D>::zero();
  for (std::size_t i = 0; i < records.size(); ++i) {
    const auto& r = records[i];
    work += r.volume * dot(force[i], r.v);
    whole += r.volume * force[i];
    size += r.volume * norm(force[i]);
    double rate = hoops * across[i] * fitted[i][0] / r.x[0];
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) rate += r.stress[EulerianRecord<D>::index(a, b)] * gradient[i](a, b);
    power += r.volume * rate;
  }
  CHECK(work == Approx(-power).margin(1e-11 * size));
  for (int k = hoops > 0 ? 1 : 0; k < D; ++k) CHECK(std::abs(whole[k]) < 1e-11 * size);
}

}  // namespace

TEST_CASE("MSPH: adjoint forces do the work of the strain rates and keep momentum", "[msph]") {
  check_adjoint<MsphWeights<1>, TruncatedGaussian, 1, 0>();
  check_adjoint<MsphWeights<1>, TruncatedGaussian, 1, 1>();
  check_adjoint<MsphWeights<1>, TruncatedGaussian, 1, 2>();
  check_adjoint<MsphWeights<2>, TruncatedGaussian, 2, 0>();
  check_adjoint<MsphWeights<2>, TruncatedGaussian, 2, 1>();
  check_adjoint<MsphWeights<3>, TruncatedGaussian, 3, 0>();
  check_adjoint<SsphWeights<CubicSpline, 2>, CubicSpline, 2, 0>();
}

TEST_CASE("MSPH: a particle with too few neighbours is answered by lower order, never by NaN", "[msph]") {
  std::vector<EulerianRecord<2>> records;
  for (const auto x : {0.0, 1.0, 2.0, 100.0}) {  // three in a row, and one alone
    EulerianRecord<2> r{};
    r.x = {{x * spacing, 0.0}};
    r.volume = spacing * spacing;
    r.density = 1.0;
    r.smoothing_length = 1.5 * spacing;
    records.push_back(r);
  }
  records.push_back(records[1]);  // a triangle allows first order
  records.back().x[1] = spacing;
  const auto pairs = pairs_of<2>(records, 3.0 * spacing);
  std::feclearexcept(FE_ALL_EXCEPT);
  const auto c = coefficients_of<MsphWeights<2>, TruncatedGaussian, 2>(records, pairs);
  CHECK(std::fetestexcept(FE_DIVBYZERO | FE_INVALID) == 0);  // runs may trap them
  CHECK(c[0].order == 1);
  CHECK(c[3].order == 0);
  for (const auto& one : c)
    for (const auto& row : one.row.c)
      for (const double value : row.c) CHECK(std::isfinite(value));
}
