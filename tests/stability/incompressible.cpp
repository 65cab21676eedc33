// Elasticity as Poisson's ratio nears a half: what the time step costs, and whether bending locks.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <numbers>

#include "support/lattice.hpp"
#include "support/said.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

constexpr double spacing = 1e-3, density = 1000.0, shear = 1e7;

struct Bending {
  double frequency;  ///< of a cantilever's first mode over that of a thin beam
  double steps;
  std::set<std::string> said;
};

/// A cantilever is struck and swings, until it turns back: a quarter of its period.
Bending bending(const std::string& scheme, double poisson) {
  constexpr int length = 20, rim = 4, high = 6;
  const double bulk = 2.0 * shear * (1.0 + poisson) / (3.0 * (1.0 - 2.0 * poisson));
  auto p =
      particles_on(Space::plane_strain,
                   {{"beam", "rubber", spacing, {-rim * spacing, 0.0}, {length + rim, high}, {0.0, 0.0}}}, density);
  p.allocate(Field::clamped);
  const double thin_modulus = 2.0 * shear / (1.0 - poisson);  // E/(1-ν²)
  const double thin =
      std::pow(1.875 / (length * spacing), 2) * high * spacing * std::sqrt(thin_modulus / (12.0 * density));  // rad/s
  for (std::size_t i = 0; i < p.count(); ++i) {
    const double x = p.reals(Field::position)[2 * i] / (length * spacing);
    p.integers(Field::clamped)[i] = x < 0.0 ? 1 : 0;
    p.reals(Field::velocity)[2 * i + 1] = x < 0.0 ? 0.0 : 1e-2 * std::sqrt(shear / density) * x * x * (3.0 - x) / 2.0;
  }
  auto simulation = simulation_of(
      fmt::format("time.end = {}\n{}viscosity = {{ model = 'monaghan', alpha = 0.0, beta = 0.0 }}\n[material.rubber]\n"
                  "density = {}\neos = {{ model = 'linear', bulk_modulus = {} }}\n"
                  "strength = {{ model = 'elastic', shear_modulus = {} }}\n",
                  10.0 / thin, scheme, density, bulk, shear),
      std::move(p));
  double before = 1.0, time = 0.0;
  while (!simulation.finished()) {
    simulation.step();
    const auto v = simulation.particles().reals(Field::velocity);
    double now = 0.0;
    for (std::size_t i = 1; i < v.size(); i += 2) now += v[i];
    if (before > 0.0 && now <= 0.0) {
      time = simulation.time();
      break;
    }
    before = now;
  }
  return {0.5 * std::numbers::pi / time / thin, static_cast<double>(simulation.steps()), said(simulation)};
}

void hold_to_prediction(const std::vector<double>& ratios, double lagrangian_locks, double eulerian_locks) {
  for (const std::string scheme : {"total-lagrangian", "eulerian"}) {
    const auto settings = "scheme.type = '" + scheme + "'\n";
    const auto soft = bending(settings, 0.3);
    Bending stiff{};
    for (const double poisson : ratios) {
      stiff = bending(settings, poisson);
      WARN(fmt::format("{}, ν = {}: {:.3f} of the thin beam's frequency, {:.3f} at 0.3; {} steps a quarter, {} at 0.3",
                       scheme, poisson, stiff.frequency, soft.frequency, stiff.steps, soft.steps));
      // c_l² is 2G(1-ν)/((1-2ν) ρ), and a thin beam's frequency goes with 1/√(1-ν).
      const double faster = std::sqrt((1.0 - poisson) / (1.0 - 2.0 * poisson) / (0.7 / 0.4));
      const double slower = std::sqrt((1.0 - poisson) / 0.7) * soft.frequency / stiff.frequency;
      CHECK(stiff.steps / soft.steps == Approx(faster * slower).epsilon(0.05));
    }
    CHECK_FALSE(soft.said.contains("locking"));
    CHECK(stiff.said.contains("locking"));
    const double locked = stiff.frequency / soft.frequency - 1.0;
    CHECK(locked > 0.5 * (scheme == "eulerian" ? eulerian_locks : lagrangian_locks));
    CHECK(locked < 1.5 * (scheme == "eulerian" ? eulerian_locks : lagrangian_locks));
  }
}

}  // namespace

TEST_CASE("Near-incompressible elasticity: steps grow shorter with the speed of sound, and bending grows too stiff") {
  hold_to_prediction({0.49}, 0.035, 0.10);
}

TEST_CASE("Near-incompressible elasticity: as near to a half as 0.4999", "[.long]") {
  hold_to_prediction({0.499, 0.4999}, 0.095, 1.49);
}
