// Gas at its extremes: the wall that heats, a shock of a hundred times the speed of sound, expansion into nothing.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "support/lattice.hpp"
#include "support/said.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

struct Case {
  std::string name, scene;
  double ratio;
};
const Case eulerian{"eulerian", "scheme.type = 'eulerian'\n", 2.0};
const Case corrected{"eulerian, mixed correction", "scheme = { type = 'eulerian', correction = 'mixed' }\n", 2.0};
const Case msph{"msph", "scheme = { type = 'msph', forces = 'adjoint' }\nsmoothing.kernel = 'truncated-gaussian'\n",
                1.5};
const Case godunov{"godunov-split", "scheme.type = 'godunov-split'\n", 2.0};

std::string gas(double heat_ratio) {
  return fmt::format("[material.gas]\ndensity = 1.0\neos = {{ model = 'ideal-gas', heat_ratio = {} }}\n", heat_ratio);
}

/// Gas of density one at rest against a wall at x = 0, or running into it.
Simulation at_wall(const Case& c, double heat_ratio, double speed, double energy, int count, double end) {
  const double spacing = 1.0 / count;
  auto p =
      particles_on(Space::line, {{"gas", "gas", spacing, {0.5 * spacing}, {count}, {-speed}, nullptr, c.ratio}}, 1.0);
  p.allocate(Field::specific_internal_energy);
  std::ranges::fill(p.reals(Field::specific_internal_energy), energy);
  auto simulation = simulation_of(
      fmt::format("symmetry.wall = {{ axis = 'x' }}\ntime.end = {}\n", end) + c.scene + gas(heat_ratio), std::move(p));
  run_to_the_end(simulation);
  return simulation;
}

/// Noh's problem: gas without pressure meets a wall at speed one, and has an energy of 1/2 behind the shock.
struct Wall {
  double at_wall = 0.0;  ///< energy of the particle at the wall, over the exact one
  double extent = 0.0;   ///< particles from the wall on that are hotter than 5 % too much
  std::set<std::string> said;
};

Wall wall_heating(const Case& c, int count) {
  const auto simulation = at_wall(c, 5.0 / 3.0, 1.0, 1e-6, count, 0.6);
  const auto e = by_id(simulation.particles(), Field::specific_internal_energy);
  Wall wall{e[0] / 0.5, 0.0, said(simulation)};
  while (e[static_cast<std::size_t>(wall.extent)] > 0.5 * 1.05) ++wall.extent;
  return wall;
}

struct StrongShock {
  double density;  ///< mean behind a shock of Mach 100 away from the wall, over the exact one: (γ+1)/(γ-1) = 6, within
                   ///< 5e-4
  std::set<std::string> said;
};

StrongShock behind_shock(const Case& c, int count) {
  constexpr double sound_speed = 0.01, speed = 2.0 / 2.4 * (100.0 - 0.01) * sound_speed;
  const auto simulation = at_wall(c, 1.4, speed, sound_speed * sound_speed / (1.4 * 0.4), count, 0.5);
  double sum = 0.0, number = 0.0;
  for (std::size_t i = 0; i < simulation.particles().count(); ++i) {
    const double x = simulation.particles().reals(Field::position)[i];
    if (x < 0.02 || x > 0.05) continue;
    sum += simulation.particles().reals(Field::density)[i];
    ++number;
  }
  return {sum / number / 6.0, said(simulation)};
}

struct Expansion {
  double edge;    ///< speed of the outermost particle
  double energy;  ///< least, over that at the start
  std::set<std::string> said;
};

/// Gas of sound speed one expands into nothing; its edge should run at 2/(γ-1) = 5.
Expansion into_vacuum(double ratio) {
  const double start = 1.0 / (1.4 * 0.4);
  const auto simulation = at_wall({"", eulerian.scene, ratio}, 1.4, 0.0, start, 800, 0.3);
  const auto e = by_id(simulation.particles(), Field::specific_internal_energy);
  return {by_id(simulation.particles(), Field::velocity).back(), *std::ranges::min_element(e) / start,
          said(simulation)};
}

}  // namespace

TEST_CASE("Wall heating: artificial viscosity leaves it over as many particles as ever, smoothing takes it away") {
  // What the shock heats too much while it is born has nowhere to go without conduction of heat.
  const auto coarse = wall_heating(eulerian, 100), fine = wall_heating(eulerian, 400);
  const auto smoothed_coarse = wall_heating(msph, 100), smoothed = wall_heating(msph, 400);
  WARN(fmt::format(
      "eulerian: {:.3f} and {:.3f} of the exact energy at the wall, over {} and {} particles; msph: {:.3f} and "
      "{:.3f}",
      coarse.at_wall, fine.at_wall, coarse.extent, fine.extent, smoothed_coarse.at_wall, smoothed.at_wall));
  CHECK(fine.at_wall > 2.0);
  CHECK(fine.at_wall == Approx(coarse.at_wall).epsilon(0.01));
  CHECK(fine.extent == coarse.extent);
  CHECK(std::abs(smoothed.at_wall - 1.0) < 0.6 * std::abs(smoothed_coarse.at_wall - 1.0));
  CHECK(fine.said.contains("wall-heating"));
  CHECK_FALSE(smoothed.said.contains("wall-heating"));
}

TEST_CASE("Strong shock: at Mach 100 the density by continuity runs ahead, at every spacing") {
  for (const auto& c : {eulerian, corrected, msph}) {
    const auto coarse = behind_shock(c, 200), fine = behind_shock(c, 400);
    WARN(fmt::format("{}: {:.3f} and {:.3f} of the exact density, with 200 and 400 particles", c.name, coarse.density,
                     fine.density));
    CHECK(fine.density > 1.1);
    CHECK(fine.density == Approx(coarse.density).epsilon(0.1));
    CHECK(coarse.said.contains("density-misfit"));
    CHECK(fine.said.contains("density-misfit"));
  }
}

TEST_CASE("Strong shock: gradients of the reference configuration keep energy and density, of either viscosity's h") {
  for (const Case& c : {Case{"total-lagrangian", "scheme.type = 'total-lagrangian'\n", 1.4},
                        Case{"adaptle", "scheme = { type = 'adaptle', conversion = 'none' }\n", 1.4}}) {
    // At speed one against a wall; what the gas has of its own is a thousandth of the motion.
    const double energy = 0.5e-3;
    const auto simulation = at_wall(c, 1.4, 1.0, energy, 100, 0.2);
    const double drift = simulation.ledger().total() / (0.5 + energy) - 1.0;
    const auto x = by_id(simulation.particles(), Field::position), p = by_id(simulation.particles(), Field::pressure);
    std::size_t i = 0;
    while (x[i] < 0.02) ++i;
    // Mach number M of the shock in the gas that comes: c₀ (M - 1/M) = 1.2, of speed one; p = p₀ (1 + 7/6 (M² - 1)).
    const double sound = std::sqrt(1.4 * 0.4 * energy), half = 0.6 / sound, mach = half + std::sqrt(half * half + 1.0);
    const double exact = 0.4 * energy * (1.0 + 7.0 / 6.0 * (mach * mach - 1.0));
    WARN(fmt::format("{}: the energy drifts by {:.2g}, pressure {:.4f} of the exact one", c.name, drift, p[i] / exact));
    CHECK(std::abs(drift) < 2e-3);
    CHECK(p[i] == Approx(exact).epsilon(0.01));
  }
}

TEST_CASE("Strong shock: the Riemann solver of small waves ends the run where the gas is cold") {
  CHECK_THROWS_WITH(wall_heating(godunov, 100), Catch::Contains("the state is no longer sane"));
}

TEST_CASE("Vacuum: gas stops to expand where its particles are out of each other's support") {
  double edge = 0.0, energy = 1.0;
  for (const double ratio : {1.4, 2.0, 4.0}) {
    const auto found = into_vacuum(ratio);
    const double least = std::pow(1.0 / (CubicSpline::support * ratio), 0.4);  // e goes with ρ^(γ-1)
    WARN(fmt::format("h/δ {}: the edge runs at {:.2f} of 5, the least energy is {:.3f}; at the support's end {:.3f}",
                     ratio, found.edge, found.energy, least));
    CHECK(found.energy > least);
    CHECK(found.energy < 1.25 * least);
    CHECK(found.edge > edge);
    CHECK(found.energy < energy);
    CHECK(found.said.contains("lost-neighbours"));
    edge = found.edge;
    energy = found.energy;
  }
}
