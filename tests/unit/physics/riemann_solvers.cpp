// What every Riemann solver has to be, and what each of them is.
#include <catch2/catch.hpp>

#include "physics/eos/shock_slope.hpp"
#include "physics/riemann/riemann.hpp"
#include "support/models.hpp"
#include "support/random_step.hpp"
#include "support/riemann.hpp"

using namespace tektite;
using test::for_each_sample;

namespace {

using Side = RiemannSide<double>;

/// ρ c² in Pa
double stiffness_of(const Side& side) { return side.density * side.sound_speed * side.sound_speed; }

Side side_of(double pressure, double velocity, double density, double sound_speed, double shock_slope) {
  return {pressure, velocity, density, sound_speed, shock_slope, 1.0 / shock_slope};
}

/// A state of some metal or gas under pressure or moderate tension.
Side random_side(test::Random& random) {
  auto side = side_of(0.0, random.between(-500.0, 500.0), random.magnitude(500.0, 2e4), random.magnitude(1e3, 1e4),
                      random.between(0.6, 2.0));
  side.pressure = random.between(-0.02, 0.5) * stiffness_of(side);
  return side;
}

template <class Body>
void for_each_pair_of_states(const Body& body) {
  test::Random random(7);
  for (int k = 0; k < 2000; ++k) {
    const auto left = random_side(random);
    body(left, random_side(random));
  }
}

/// Pressures of a solution are rounded in units of ρ c², speeds in units of c.
double pressure_scale(const Side& l, const Side& r) { return std::max(stiffness_of(l), stiffness_of(r)); }

constexpr double rounding = 1e-12;  // some tens of operations, and a root

}  // namespace

TEST_CASE("Riemann solvers: equal sides are left as they are", "[riemann]") {
  for_each_sample<Riemann>([](const auto& solver) {
    for_each_pair_of_states([&](const Side& side, const Side&) {
      const auto star = solver(side, side);
      REQUIRE(star.pressure == Approx(side.pressure).margin(rounding * stiffness_of(side)));
      REQUIRE(star.velocity == Approx(side.velocity).margin(rounding * side.sound_speed));
    });
  });
}

TEST_CASE("Exact Riemann solver: gases without energy meet in strong shocks, or stay as they are", "[riemann]") {
  const double gamma = 5.0 / 3.0, slope = shock_slope(IdealGas{1.0, gamma});
  CHECK(slope == Approx((gamma + 1.0) / 4.0));
  for (const double speed : {0.0, 1e-3, 1.0, 1e4}) {
    const auto star = ExactRiemann{}(side_of(0.0, speed, 2.0, 0.0, slope), side_of(0.0, -speed, 2.0, 0.0, slope));
    CHECK(star.pressure ==
          Approx(0.5 * (gamma + 1.0) * 2.0 * speed * speed).margin(1e-100));  // p = ρ u (u + shock speed)
    CHECK(star.velocity == Approx(0.0).margin(rounding * speed));
  }
}

TEST_CASE("Riemann solvers: seen from the other side the answer is the same", "[riemann]") {
  for_each_sample<Riemann>([](const auto& solver) {
    for_each_pair_of_states([&](const Side& left, const Side& right) {
      const auto reflected = [](Side side) {
        side.velocity = -side.velocity;
        return side;
      };
      const auto star = solver(left, right), other = solver(reflected(right), reflected(left));
      REQUIRE(other.pressure == Approx(star.pressure).margin(rounding * pressure_scale(left, right)));
      REQUIRE(other.velocity == Approx(-star.velocity).margin(rounding * 1e4));
    });
  });
}

TEST_CASE("Riemann solvers: a moving observer sees the same, moving", "[riemann]") {
  for_each_sample<Riemann>([](const auto& solver) {
    for_each_pair_of_states([&](const Side& left, const Side& right) {
      const auto moved = [](Side side) {
        side.velocity += 1234.0;
        return side;
      };
      const auto star = solver(left, right), other = solver(moved(left), moved(right));
      REQUIRE(other.pressure == Approx(star.pressure).margin(rounding * pressure_scale(left, right)));
      REQUIRE(other.velocity - 1234.0 == Approx(star.velocity).margin(rounding * 1e4));
    });
  });
}

TEST_CASE("Riemann solvers: an isolated contact is left alone, whatever the materials", "[riemann]") {
  for_each_sample<Riemann>([](const auto& solver) {
    for_each_pair_of_states([&](const Side& left, Side right) {
      right.pressure = left.pressure;
      right.velocity = left.velocity;
      const auto star = solver(left, right);
      REQUIRE(star.pressure == Approx(left.pressure).margin(rounding * pressure_scale(left, right)));
      REQUIRE(star.velocity == Approx(left.velocity).margin(rounding * 1e4));
    });
  });
}

TEST_CASE("Riemann solvers: what is compressed on both sides and closes in stays compressed", "[riemann]") {
  for_each_sample<Riemann>([](const auto& solver) {
    for_each_pair_of_states([&](Side left, Side right) {
      left.pressure = std::abs(left.pressure);
      right.pressure = std::abs(right.pressure);
      left.velocity = std::abs(left.velocity);
      right.velocity = -std::abs(right.velocity);
      REQUIRE(solver(left, right).pressure >= std::min(left.pressure, right.pressure));
    });
  });
}

TEST_CASE("Riemann solvers: weak waves are sound", "[riemann]") {
  for_each_sample<Riemann>([](const auto& solver) {
    for_each_pair_of_states([&](const Side& left, Side right) {
      constexpr double weak = 1e-5;  // what is left over is of the order of its square
      right.pressure = left.pressure + weak * right.pressure;
      right.velocity = left.velocity + weak * right.velocity;
      const auto star = solver(left, right), sound = AcousticRiemann{}(left, right);
      REQUIRE(star.pressure == Approx(sound.pressure).margin(100.0 * weak * weak * pressure_scale(left, right)));
      REQUIRE(star.velocity == Approx(sound.velocity).margin(100.0 * weak * weak * 1e4));
    });
  });
}

TEST_CASE("Riemann solvers: several problems at once give what each gives alone", "[riemann]") {
  for_each_sample<Riemann>([](const auto& solver) {
    test::Random random(8);
    for (int repeat = 0; repeat < 200; ++repeat) {
      std::array<Side, pack_width> left, right;
      for (std::size_t k = 0; k < pack_width; ++k) {
        left[k] = random_side(random);
        right[k] = random_side(random);
      }
      const auto lanes = [](const auto& sides) {
        const auto of = [&](double Side::*member) { return Pack([&](auto lane) { return sides[lane].*member; }); };
        return RiemannSide<Pack>{of(&Side::pressure),    of(&Side::velocity),    of(&Side::density),
                                 of(&Side::sound_speed), of(&Side::shock_slope), of(&Side::inverse_slope)};
      };
      const auto together = solver(lanes(left), lanes(right));
      for (std::size_t k = 0; k < pack_width; ++k) {
        const auto alone = solver(left[k], right[k]);
        REQUIRE(together.pressure[k] == Approx(alone.pressure).margin(rounding * pressure_scale(left[k], right[k])));
        REQUIRE(together.velocity[k] == Approx(alone.velocity).margin(rounding * 1e4));
      }
    }
  });
}

TEST_CASE("Two-shock solver: both sides' shock relations are met", "[riemann]") {
  for_each_pair_of_states([](const Side& left, Side right) {
    right.velocity = left.velocity - std::abs(right.velocity) - 0.2 * left.sound_speed;  // two shocks
    right.pressure = left.pressure;
    const auto star = TwoShockRiemann{}(left, right);
    const auto behind = [&](const Side& side) {
      const double jump = std::abs(star.velocity - side.velocity);
      return side.pressure + side.density * jump * (side.sound_speed + side.shock_slope * jump);
    };
    REQUIRE(star.pressure == Approx(behind(left)).margin(rounding * pressure_scale(left, right)));
    REQUIRE(star.pressure == Approx(behind(right)).margin(rounding * pressure_scale(left, right)));
  });
}

TEST_CASE("Two-shock solver: equal plates of Mie-Grüneisen material meet on their Hugoniot", "[riemann]") {
  const MieGrueneisen copper{8930.0, 3940.0, 1.489, 2.02};
  const double slope = shock_slope(copper);
  const auto flyer = side_of(0.0, 1000.0, 8930.0, 3940.0, slope), plate = side_of(0.0, 0.0, 8930.0, 3940.0, slope);
  const auto star = TwoShockRiemann{}(flyer, plate);
  CHECK(star.velocity == Approx(500.0).epsilon(rounding));
  CHECK(star.pressure == Approx(8930.0 * (3940.0 + 1.489 * 500.0) * 500.0).epsilon(1e-6));  // that of the slope
}

TEST_CASE("Exact solver: shocks and rarefactions of the stiffened gas are those of its equation of state",
          "[riemann]") {
  const StiffenedGas gas{1000.0, 1500.0, 3.0};
  const auto side = [&](double rho, double v, double e) {
    return side_of(gas.pressure(rho, e), v, rho, std::sqrt(sound_speed_squared(gas, rho, e)), shock_slope(gas));
  };
  struct Case {
    double left_density, left_velocity, right_density, right_velocity;
  };
  for (const auto& c : {Case{1000.0, 300.0, 1000.0, 0.0}, Case{1200.0, 0.0, 1000.0, 0.0},
                        Case{1100.0, -200.0, 1100.0, 200.0}, Case{1000.0, 2000.0, 1050.0, -1000.0}}) {
    const test::RiemannProblem problem(gas, {c.left_density, c.left_velocity, 2e4, 0.0},
                                       {c.right_density, c.right_velocity, 0.0, 0.0});
    const auto star =
        ExactRiemann{}(side(c.left_density, c.left_velocity, 2e4), side(c.right_density, c.right_velocity, 0.0));
    // The problem's fan is good to (1/20000)², the slope A to 1e-6.
    CHECK(star.pressure == Approx(problem.contact_pressure()).epsilon(1e-5));
    CHECK(star.velocity == Approx(problem.contact_velocity()).margin(1e-5 * 1500.0));
  }
}

TEST_CASE("Shock slope: it is that of the Hugoniot at its foot", "[riemann]") {
  CHECK(shock_slope(MieGrueneisen{2785.0, 5328.0, 1.338, 2.0}) == Approx(1.338).epsilon(1e-5));
  CHECK(shock_slope(MieGrueneisen{6100.0, 5077.0, 1.201, 0.0}) == Approx(1.201).epsilon(1e-5));
  CHECK(shock_slope(StiffenedGas{2785.0, 5328.0, 2.0}) == Approx(0.75).epsilon(1e-5));
  CHECK(shock_slope(LinearEos{2785.0, 79e9}) == Approx(0.5).epsilon(1e-5));
}
