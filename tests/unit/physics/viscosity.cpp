// What every artificial viscosity has to be: a pair term that only takes kinetic energy away.
#include "physics/viscosity/viscosity.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "core/tensor.hpp"
#include "support/models.hpp"

using namespace tektite;
using test::for_each_sample;

namespace {

struct PairState {
  Vector<double, 3> x, v;  ///< x_ij in m, v_ij in m/s
  double h, c, rho;
};

PairState random_pair(std::mt19937& generator) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  PairState pair;
  for (int k = 0; k < 3; ++k) {
    pair.x[k] = 1e-3 * number(generator);
    pair.v[k] = 3e3 * number(generator);
  }
  pair.h = 1e-3 * (1.5 + number(generator));
  pair.c = 4e3 * (1.1 + number(generator));
  pair.rho = 3e3 * (1.1 + number(generator));
  return pair;
}

template <class Model>
auto evaluate(const Model& viscosity, const PairState& p) {
  return viscosity(dot(p.v, p.x), dot(p.x, p.x), p.h, p.c, p.rho);
}

}  // namespace

TEST_CASE("Viscosities: approaching particles are heated and slowed, receding ones left alone", "[viscosity]") {
  for_each_sample<Viscosity>([](const auto& viscosity) {
    std::mt19937 generator(2);
    for (int repeat = 0; repeat < 1000; ++repeat) {
      const auto pair = random_pair(generator);
      const double approach = dot(pair.v, pair.x);
      const auto [pi, speed] = evaluate(viscosity, pair);
      CAPTURE(approach, pi, speed);
      if (approach < 0.0) {
        REQUIRE(pi > 0.0);  // a repulsion; the heat ½ m Π v·∇W is positive with it, because ∇W points against x_ij
        REQUIRE(speed > 0.0);
      } else {
        REQUIRE(pi == 0.0);
        REQUIRE(speed == 0.0);
      }
    }
  });
}

TEST_CASE("Viscosities: both particles of a pair feel the same", "[viscosity]") {
  for_each_sample<Viscosity>([](const auto& viscosity) {
    std::mt19937 generator(3);
    for (int repeat = 0; repeat < 100; ++repeat) {
      const auto pair = random_pair(generator);
      const PairState other{-1.0 * pair.x, -1.0 * pair.v, pair.h, pair.c, pair.rho};
      REQUIRE(evaluate(viscosity, pair).pi == evaluate(viscosity, other).pi);
    }
  });
}

TEST_CASE("Viscosities: several pairs at once give what each gives alone", "[viscosity]") {
  for_each_sample<Viscosity>([](const auto& viscosity) {
    std::mt19937 generator(4);
    for (int repeat = 0; repeat < 100; ++repeat) {
      std::array<PairState, pack_width> pairs;
      for (auto& pair : pairs) pair = random_pair(generator);
      const auto lanes = [&](auto member) { return Pack([&](auto lane) { return member(pairs[lane]); }); };
      const auto together = viscosity(
          lanes([](const PairState& p) { return dot(p.v, p.x); }),
          lanes([](const PairState& p) { return dot(p.x, p.x); }), lanes([](const PairState& p) { return p.h; }),
          lanes([](const PairState& p) { return p.c; }), lanes([](const PairState& p) { return p.rho; }));
      for (std::size_t lane = 0; lane < pack_width; ++lane) {
        const auto alone = evaluate(viscosity, pairs[lane]);
        REQUIRE(together.pi[lane] == Approx(alone.pi).epsilon(1e-14));  // fused or not: a last bit of each operation
        REQUIRE(together.speed[lane] == Approx(alone.speed).epsilon(1e-14));
      }
    }
  });
}

TEST_CASE("Monaghan's viscosity: the value is that of its equation", "[viscosity]") {
  const MonaghanViscosity viscosity{1.5, 4.0};
  // h = 2, r² = 1, v·x = -3: μ = -6/1.04; c̄ = 5, ρ̄ = 10: Π = (1.5·5·(6/1.04) + 4·(6/1.04)²)/10
  const double mu = 6.0 / 1.04;
  const auto [pi, speed] = viscosity(-3.0, 1.0, 2.0, 5.0, 10.0);
  CHECK(speed == Approx(mu).epsilon(1e-15));
  CHECK(pi == Approx((7.5 * mu + 4.0 * mu * mu) / 10.0).epsilon(1e-14));
}

TEST_CASE("Limited viscosity: a linear motion is not damped, a jump is as it is, and nothing that recedes",
          "[viscosity]") {
  const auto of = [](double approach, double a, double b) { return LimitedViscosity::reconstructed(approach, a, b); };
  CHECK(of(-3.0, -3.0, -3.0) == 0.0);                       // both gradients explain it
  CHECK(of(-3.0, 0.0, 0.0) == -3.0);                        // none does
  CHECK(of(-3.0, -3.0, 0.0) == -3.0);                       // one alone: an edge of a shock
  CHECK(of(-3.0, -4.0, 1.0) == -3.0);                       // they disagree
  CHECK(of(-3.0, -2.0, -1.0) == Approx(-3.0 + 4.0 / 3.0));  // eq. 35: φ = 8/9 of the mean 3/2
  CHECK(of(-3.0, -9.0, -9.0) == 0.0);                       // more than explained
  CHECK(of(3.0, 5.0, 5.0) == 0.0);
}
