// What every slope limiter has to be. limiter(a, b) is the paper's φ(b/a) a.
#include "physics/limiters/limiter.hpp"

#include <catch2/catch.hpp>

#include "support/models.hpp"
#include "support/random_step.hpp"

using namespace tektite;
using test::for_each_sample;

namespace {

constexpr double rounding = 1e-14;  // a few operations

/// body(r) over ratios of slopes of either sign, from far below one to far above.
template <class Body>
void for_each_ratio(const Body& body) {
  test::Random random(5);
  for (int k = 0; k < 1000; ++k) {
    const double r = random.magnitude(1e-4, 1e4);
    body(r);
    body(-r);
  }
}

}  // namespace

TEST_CASE("Limiters: equal slopes are left as they are", "[limiter]") {
  for_each_sample<Limiter>([](const auto& limiter) {
    for (const double slope : {-3e9, -1.0, 1e-3, 7e5}) CHECK(limiter(slope, slope) == Approx(slope).epsilon(rounding));
  });
}

TEST_CASE("Limiters: at an extremum there is no slope", "[limiter]") {
  for_each_sample<Limiter>([](const auto& limiter) {
    for_each_ratio([&](double r) {
      if (r < 0.0) CHECK(limiter(1.0, r) == 0.0);
    });
    CHECK(limiter(0.0, 5.0) == 0.0);
    CHECK(limiter(5.0, 0.0) == 0.0);
    CHECK(limiter(0.0, 0.0) == 0.0);
  });
}

TEST_CASE("Limiters: they lie in the region of total variation diminishing schemes of second order", "[limiter]") {
  // Sweby (1984): between min(r, 1) and max(r, 1) for second order, under 2 r and 2 for TVD.
  for_each_sample<Limiter>([](const auto& limiter) {
    for_each_ratio([&](double r) {
      if (r < 0.0) return;
      CAPTURE(r);
      const double phi = limiter(1.0, r);
      REQUIRE(phi <= 2.0 * (1.0 + rounding));
      REQUIRE(phi <= 2.0 * r * (1.0 + rounding));
      REQUIRE(phi >= std::min(1.0, r) * (1.0 - rounding));
      REQUIRE(phi <= std::max(1.0, r) * (1.0 + rounding));
    });
  });
}

TEST_CASE("Limiters: both particles of a pair get one slope, φ(r)/r = φ(1/r)", "[limiter]") {
  for_each_sample<Limiter>([](const auto& limiter) {
    for_each_ratio([&](double r) {
      CAPTURE(r);
      REQUIRE(limiter(1.0, r) == Approx(limiter(r, 1.0)).epsilon(rounding));
      REQUIRE(limiter(1.0, r) == Approx(r * limiter(1.0, 1.0 / r)).epsilon(rounding));
      REQUIRE(limiter(-1.0, -r) == -limiter(1.0, r));
    });
  });
}

TEST_CASE("Limiters: the values are those of the printed formulas", "[limiter]") {
  const SwebyLimiter minmod{1.0}, superbee{2.0};
  for_each_ratio([&](double r) {
    CAPTURE(r);
    const double mc = std::max(0.0, std::min({2.0 * r, 0.5 * (1.0 + r), 2.0}));
    const double leer = (r + std::abs(r)) / (1.0 + std::abs(r));
    const auto sweby = [r](double beta) { return std::max({0.0, std::min(beta * r, 1.0), std::min(r, beta)}); };
    REQUIRE(MonotonizedCentralLimiter{}(1.0, r) == Approx(mc).epsilon(rounding));
    REQUIRE(VanLeerLimiter{}(1.0, r) == Approx(leer).epsilon(rounding));
    REQUIRE(minmod(1.0, r) == Approx(sweby(1.0)).epsilon(rounding));
    REQUIRE(superbee(1.0, r) == Approx(sweby(2.0)).epsilon(rounding));
  });
}

TEST_CASE("Limiters: several pairs at once give what each gives alone", "[limiter]") {
  for_each_sample<Limiter>([](const auto& limiter) {
    test::Random random(6);
    for (int repeat = 0; repeat < 100; ++repeat) {
      const Pack a([&](auto) { return random.between(-1.0, 1.0); }), b([&](auto) { return random.between(-1.0, 1.0); });
      const Pack together = limiter(a, b);
      for (std::size_t lane = 0; lane < pack_width; ++lane)
        REQUIRE(together[lane] == Approx(limiter(double(a[lane]), double(b[lane]))).epsilon(rounding));
    }
  });
}
