#include "passes/conversion.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace tektite;

namespace {

template <int D>
Tensor<double, D> diagonal(std::initializer_list<double> values) {
  auto f = Tensor<double, D>::zero();
  int k = 0;
  for (const double value : values) {
    f(k, k) = value;
    ++k;
  }
  return f;
}

/// The rotation in the first two axes.
template <int D>
Tensor<double, D> rotation(double angle) {
  auto r = Tensor<double, D>::zero();
  for (int k = 2; k < D; ++k) r(k, k) = 1.0;
  r(0, 0) = r(1, 1) = std::cos(angle);
  r(1, 0) = std::sin(angle);
  r(0, 1) = -r(1, 0);
  return r;
}

template <int D>
Tensor<double, D> product(const Tensor<double, D>& a, const Tensor<double, D>& b) {
  auto c = Tensor<double, D>::zero();
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      for (int k = 0; k < D; ++k) c(i, j) += a(i, k) * b(k, j);
  return c;
}

}  // namespace

TEST_CASE("Equivalent strain: stretching along one axis at constant volume gives the logarithm of the stretch") {
  const double stretch = std::exp(0.85);
  CHECK(equivalent_strain(diagonal<3>({stretch, 1 / std::sqrt(stretch), 1 / std::sqrt(stretch)})) == Approx(0.85));
  // In the plane nothing is across it: ε = (e, -e, 0), √(2/3 · 2 e²).
  CHECK(equivalent_strain(diagonal<2>({stretch, 1 / stretch})) == Approx(0.85 * std::sqrt(4.0 / 3.0)));
  // On a line ε = (e, 0, 0), whose deviator is (2, -1, -1) e/3.
  CHECK(equivalent_strain(diagonal<1>({stretch})) == Approx(0.85 * 2.0 / 3.0));
}

TEST_CASE("Equivalent strain: a change of volume alone has none in three dimensions") {
  CHECK(equivalent_strain(diagonal<3>({1.2, 1.2, 1.2})) == Approx(0.0).margin(1e-12));
}

TEST_CASE("Equivalent strain: rotations before and after change nothing") {
  const auto f = diagonal<3>({1.4, 0.8, 0.95});
  const auto turned = product(rotation<3>(0.7), product(f, rotation<3>(-1.9)));
  CHECK(equivalent_strain(turned) == Approx(equivalent_strain(f)).epsilon(1e-12));
  const auto g = diagonal<2>({1.4, 0.8});
  CHECK(equivalent_strain(product(rotation<2>(0.7), product(g, rotation<2>(2.2)))) ==
        Approx(equivalent_strain(g)).epsilon(1e-12));
}

TEST_CASE("Equivalent strain: a body that turns round has none") {
  CHECK(equivalent_strain(rotation<2>(std::numbers::pi)) == Approx(0.0).margin(1e-12));
}

TEST_CASE("Strain limit: exceeded just where the equivalent strain is beyond it", "[conversion]") {
  const StrainLimit limit(0.85);
  for (const double strain : {0.1, 0.5, 0.8, 0.8499, 0.8501, 0.9, 2.0}) {
    INFO(strain);
    const double stretch = std::exp(strain);
    for (const double angle : {0.0, 0.7}) {
      const auto turned = [&](const Tensor<double, 2>& f) { return product(rotation<2>(angle), f); };
      for (const auto& f : {turned(diagonal<2>({stretch, 1.0})), turned(diagonal<2>({1.0 / stretch, 1.0})),
                            turned(diagonal<2>({stretch, 1.0 / stretch}))})
        CHECK(limit.exceeded_by(f) == (equivalent_strain(f) > 0.85));
    }
    for (const auto& f : {diagonal<3>({stretch, stretch, 1.0 / stretch}), diagonal<3>({stretch, 1.0, 1.0}),
                          diagonal<3>({1.0 / stretch, 1.0 / stretch, stretch})})
      CHECK(limit.exceeded_by(f) == (equivalent_strain(f) > 0.85));
    CHECK(limit.exceeded_by(diagonal<1>({stretch})) == (equivalent_strain(diagonal<1>({stretch})) > 0.85));
  }
}
