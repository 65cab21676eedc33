// The arithmetic of studies, against values worked out by hand or published.

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "postprocess/accuracy/convergence.hpp"
#include "postprocess/accuracy/cost.hpp"

using namespace tektite;

TEST_CASE("Rates: halving the spacing that quarters the error is order two") {
  CHECK(observed_order({0.2, 0.08}, {0.1, 0.02}).value() == Approx(2.0));
  CHECK(observed_order({0.2, 0.02}, {0.1, 0.08}).value() == Approx(-2.0));
  CHECK_FALSE(observed_order({0.2, 0.0}, {0.1, 0.02}));
  CHECK_FALSE(observed_order({0.1, 0.08}, {0.1, 0.02}));
}

TEST_CASE("Rates: of many errors the slope of least squares") {
  // In ln h / ln 2 = 2, 1, 0 and ln e / ln 2 = 3, 0, 0: means 1 and 1, slope (1·2 + 0 + 1·1)/2.
  CHECK(fitted_order(std::array<Sample, 3>{{{4, 8}, {2, 1}, {1, 1}}}).value() == Approx(1.5));
  CHECK_FALSE(fitted_order(std::array<Sample, 1>{{{4, 8}}}));
  CHECK_FALSE(fitted_order(std::array<Sample, 2>{{{4, 8}, {4, 4}}}));
  CHECK_FALSE(fitted_order(std::array<Sample, 2>{{{4, 8}, {2, 0}}}));
}

TEST_CASE("Richardson: the example of Celik et al. (2008), Table 1, reattachment length") {
  // 18 000, 8000 and 4500 cells in the plane.
  const std::array<double, 3> h{1.0 / std::sqrt(18000.0), 1.0 / std::sqrt(8000.0), 1.0 / std::sqrt(4500.0)};
  const auto estimate = extrapolate({{{h[0], 6.063}, {h[1], 5.972}, {h[2], 5.863}}});
  CHECK(estimate.approach == Approach::monotone);
  CHECK(estimate.order == Approx(1.53).margin(0.005));                  // printed with these digits
  CHECK(estimate.value == Approx(6.1685).margin(0.0005));               // printed 6.1685
  CHECK(estimate.uncertainty / 6.063 == Approx(0.022).margin(0.0005));  // printed 2.2 %
}

TEST_CASE("Richardson: a quadratic sequence is extrapolated exactly, for equal and for unequal ratios") {
  const auto quadratic = [](double h) { return Sample{h, 5.0 + 3.0 * h * h}; };
  for (const double coarse : {4.0, 3.0}) {
    const auto estimate = extrapolate({{quadratic(1.0), quadratic(2.0), quadratic(coarse)}});
    CHECK(estimate.approach == Approach::monotone);
    CHECK(estimate.order == Approx(2.0).epsilon(1e-12));
    CHECK(estimate.value == Approx(5.0).epsilon(1e-12));
    CHECK(estimate.uncertainty == Approx(1.25 * 9.0 / 3.0).epsilon(1e-12));
  }
}

TEST_CASE("Richardson: what oscillates, does not converge or does not change is told apart") {
  const auto oscillating = extrapolate({{{1, 10.0}, {2, 11.0}, {4, 7.0}}});  // changes -1 and +4
  CHECK(oscillating.approach == Approach::oscillatory);
  CHECK(oscillating.order == Approx(2.0));  // 4 = 2^p
  CHECK(oscillating.value == Approx(10.0 - 1.0 / 3.0));
  const auto diverging = extrapolate({{{1, 10.0}, {2, 13.0}, {4, 14.0}}});
  CHECK(diverging.approach == Approach::diverging);
  CHECK(diverging.uncertainty == 0.0);
  CHECK(extrapolate({{{1, 10.0}, {2, 13.0}, {4, 16.0}}}).approach == Approach::diverging);  // order zero
  CHECK(extrapolate({{{1, 10.0}, {2, 10.0}, {4, 16.0}}}).approach == Approach::unchanged);
  CHECK(extrapolate({{{1, 10.0}, {2, 16.0}, {4, 16.0}}}).approach == Approach::unchanged);
}

TEST_CASE("Pareto front: runs that no other beats, by rising cost") {
  const std::array<Judged, 6> runs{{{4, 0.1}, {1, 0.5}, {2, 0.6}, {3, 0.2}, {5, 0.1}, {1, 0.5}}};
  CHECK(pareto_front(runs) == std::vector<std::size_t>{1, 3, 0});
  CHECK(pareto_front({}).empty());
}

TEST_CASE("Cost of an error: straight in logarithms between the runs on either side") {
  // From 1 s and 10 % to 100 s and 0.1 %: 1 % is half way, 10 s.
  const std::array<Judged, 2> line{{{1, 0.1}, {100, 0.001}}};
  const auto between = cost_of_error(line, 0.01).value();
  CHECK(between.cost == Approx(10.0));
  CHECK_FALSE(between.at_most);
  CHECK_FALSE(cost_of_error(line, 1e-4));
  const auto first = cost_of_error(line, 0.2).value();
  CHECK(first.cost == 1.0);
  CHECK(first.at_most);
  CHECK_FALSE(cost_of_error({}, 0.01));
}

TEST_CASE("Cost of an error: the cheapest crossing counts, also where a finer run is worse again or has no error") {
  const std::array<Judged, 4> line{{{1, 0.1}, {2, 0.01}, {4, 0.04}, {8, 0.005}}};
  CHECK(cost_of_error(line, 0.01).value().cost == Approx(2.0));
  CHECK(cost_of_error(line, 0.02).value().cost < 2.0);
  CHECK(cost_of_error(std::array<Judged, 2>{{{1, 0.1}, {2, 0.0}}}, 0.01).value().cost == 2.0);
}
