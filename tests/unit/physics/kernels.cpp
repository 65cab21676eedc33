// What every kernel has to be: W = σ_D / h^D w(q).
#include "physics/kernels/kernel.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "support/models.hpp"

using namespace tektite;

namespace {

constexpr double h = 0.37;  // m; not 1, so that a wrong power of h shows

/// body(kernel, dimension) as types, for every registered kernel in one, two and three dimensions.
template <class Body>
void for_each_kernel(const Body& body) {
  test::for_each_model(std::type_identity<Kernel>{}, [&]<class K>(std::type_identity<K>) {
    INFO(K::name);
    body(K{}, std::integral_constant<int, 1>{});
    body(K{}, std::integral_constant<int, 2>{});
    body(K{}, std::integral_constant<int, 3>{});
  });
}

/// Simpson's rule over [0, support h], with whole panels on either side of every multiple of h, where pieces may meet.
template <class F>
double integral(const F& f, double support) {
  constexpr int panels = 400;  // a unit of q: an error of order (1/400)^4 = 4e-11
  const int count = static_cast<int>(support * panels);
  const double width = h / panels;
  double sum = 0.0;
  for (int k = 0; k < count; ++k) sum += width / 6.0 * (f(k * width) + 4.0 * f((k + 0.5) * width) + f((k + 1) * width));
  return sum;
}

double sphere_surface(int dimensions, double r) {
  using std::numbers::pi;
  return dimensions == 1 ? 2.0 : dimensions == 2 ? 2.0 * pi * r : 4.0 * pi * r * r;
}

}  // namespace

TEST_CASE("Kernels: the integral over space is one", "[kernels]") {
  for_each_kernel([](auto kernel, auto d) {
    using K = decltype(kernel);
    CAPTURE(d.value);
    const auto shell = [&](double r) { return sphere_surface(d, r) * kernel_value<K, d.value>(r, h); };
    CHECK(integral(shell, K::support) == Approx(1.0).epsilon(1e-9));  // the error of the rule
  });
}

TEST_CASE("Kernels: the slope is the derivative of the value", "[kernels]") {
  for_each_kernel([](auto kernel, auto d) {
    using K = decltype(kernel);
    CAPTURE(d.value);
    const double step = 1e-5 * h;
    const double scale = kernel_value<K, d.value>(0.0, h) / h;
    double worst = 0.0;
    for (double q = 1e-3; q < K::support - 1e-3; q += 1e-3) {
      const double difference =
          (kernel_value<K, d.value>(q * h + step, h) - kernel_value<K, d.value>(q * h - step, h)) / (2.0 * step);
      worst = std::max(worst, std::abs(kernel_slope<K, d.value>(q * h, h) - difference) / scale);
    }
    CHECK(worst < 1e-9);  // (1e-5)² for the difference, 1e-16/1e-5 for its rounding
  });
}

TEST_CASE("Kernels: positive within the support and zero beyond", "[kernels]") {
  for_each_kernel([](auto kernel, auto d) {
    using K = decltype(kernel);
    CAPTURE(d.value);
    for (int k = 0; k < 100; ++k) REQUIRE(kernel_value<K, d.value>(k / 100.0 * K::support * h, h) > 0.0);
    for (const double q : {1.0, 1.001, 2.0}) {
      CHECK(kernel_value<K, d.value>(q * K::support * h, h) == 0.0);
      CHECK(kernel_slope<K, d.value>(q * K::support * h, h) == 0.0);
    }
    const double edge = kernel_value<K, d.value>(K::support * h * (1.0 - 1e-9), h);
    CHECK(edge < 1e-8 * kernel_value<K, d.value>(0.0, h));  // continuous there
  });
}

TEST_CASE("Kernels: the value falls with the distance", "[kernels]") {
  for_each_kernel([](auto kernel, auto d) {
    using K = decltype(kernel);
    CAPTURE(d.value);
    CHECK(kernel_slope<K, d.value>(0.0, h) == 0.0);
    for (int k = 1; k < 100; ++k) REQUIRE(kernel_slope<K, d.value>(k / 100.0 * K::support * h, h) < 0.0);
  });
}

TEST_CASE("Kernels: the slope over the distance is finite at none", "[kernels]") {
  for_each_kernel([](auto kernel, auto) {
    using K = decltype(kernel);
    CHECK(K::slope_over_q(0.0) == Approx(K::slope_over_q(1e-7)).epsilon(1e-6));  // w''(0) + O(q)
  });
}

TEST_CASE("Kernels: the slope is that over the distance, times the distance", "[kernels]") {
  for_each_kernel([](auto kernel, auto) {
    using K = decltype(kernel);
    for (int k = 1; k < 100; ++k) {
      const double q = k / 100.0 * K::support;
      REQUIRE(K::slope(q) == Approx(q * K::slope_over_q(q)).epsilon(1e-14));  // a few roundings
    }
  });
}

TEST_CASE("Kernels: several distances at once give what each gives alone", "[kernels]") {
  for_each_kernel([](auto kernel, auto) {
    using K = decltype(kernel);
    for (int k = 0; k < 25; ++k) {
      const Pack q([&](int lane) { return K::support * (4 * k + lane) / 100.0; });
      const Pack shape = K::shape(q), slope = K::slope_over_q(q);
      for (int lane = 0; lane < static_cast<int>(pack_width); ++lane) {
        const double one = q[lane];
        REQUIRE(shape[lane] == Approx(K::shape(one)).margin(4e-16));         // fused or not: a last bit of w(0) ~ 1
        REQUIRE(slope[lane] == Approx(K::slope_over_q(one)).margin(2e-15));  // and of w'/q(0) ~ 5
      }
    }
  });
}
