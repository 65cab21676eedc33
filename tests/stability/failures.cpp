// Runs that fail as the linear analysis says, and say so by name.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "run/too_near.hpp"
#include "run/watch.hpp"
#include "support/lattice.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

constexpr double spacing = 1e-3, density = 2785.0, bulk = 79e9;
const std::string metal =
    "[material.metal]\ndensity = 2785.0\neos = { model = 'linear', bulk_modulus = 79e9 }\n"
    "strength = { model = 'elastic', shear_modulus = 27.6e9 }\n";

/// A square of metal under a mean tension of 5 GPa, its rim clamped, its particles off their places by a thousandth of
/// the spacing, after as long as a wave needs to run through 220 particles.
Simulation pulled_square(const std::string& scheme) {
  constexpr int side = 22, rim = 4;
  const double rest = density * (1.0 - 5e9 / bulk);
  auto particles =
      particles_on(Space::plane_strain, {{"square", "metal", spacing, {0.0, 0.0}, {side, side}, {0.0, 0.0}}}, rest);
  particles.allocate(Field::clamped);
  for (std::size_t i = 0; i < particles.count(); ++i) {
    bool inside = true;
    for (std::size_t k = 0; k < 2; ++k) {
      auto& x = particles.reals(Field::position)[2 * i + k];
      const auto place = std::lround(x / spacing);
      inside = inside && place >= rim && place < side - rim;
      const auto number = static_cast<double>((2 * i + k) * 7919 % 101) - 50.0;
      x += 1e-3 * spacing * number / 50.0;
    }
    particles.integers(Field::clamped)[i] = inside ? 0 : 1;
  }
  auto simulation = simulation_of("time.end = 35e-6\nscheme.type = '" + scheme + "'\n" + metal, std::move(particles));
  run_to_the_end(simulation);
  return simulation;
}

double farthest_from_places(const Simulation& simulation) {
  double farthest = 0.0;
  for (const double x : simulation.particles().reals(Field::position))
    farthest = std::max(farthest, std::abs(x / spacing - std::round(x / spacing)));
  return farthest;  // of the spacing; a half and more shows as less
}

}  // namespace

TEST_CASE("Tensile instability: a pulled square of Eulerian particles clumps, and the run says so") {
  const auto simulation = pulled_square("eulerian");
  const auto& particles = simulation.particles();
  Watch watch;
  const auto warnings = watch.look(particles, simulation.settings(), {});
  WARN("clumped: " << clumped_part(particles, particles.bodies()[0])
                   << ", farthest from its place: " << farthest_from_places(simulation));
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].name == "clumping");
  CHECK_THAT(warnings[0].text, Catch::Contains("kernels or scheme.artificial_stress may mend it"));
  CHECK(watch.names().contains("clumping"));
  CHECK(watch.look(particles, simulation.settings(), {}).empty());  // told once
}

TEST_CASE("Tensile instability: no remedy is named that the scheme does not know") {
  const auto simulation = pulled_square("godunov-split");
  const auto warnings = Watch().look(simulation.particles(), simulation.settings(), {});
  REQUIRE(!warnings.empty());
  CHECK(warnings[0].name == "clumping");
  CHECK_THAT(warnings[0].text, Catch::Contains("total-Lagrangian kernels may mend it"));
}

TEST_CASE("Tensile instability: with kernels of the reference configuration the pulled square stays as it is") {
  const auto simulation = pulled_square("total-lagrangian");
  CHECK(farthest_from_places(simulation) < 0.01);
  Watch watch;
  CHECK(watch.look(simulation.particles(), simulation.settings(), {}).empty());
}

TEST_CASE("Watch: what is found of many bodies has one line for all of them") {
  const auto warnings_of = [](int bodies) {
    std::vector<Lattice> lattices;
    for (int k = 0; k < bodies; ++k)
      lattices.push_back({"ball" + std::to_string(k), "rubber", spacing, {0.0, 20 * k * spacing}, {8, 8}, {0.0, 0.0}});
    const auto simulation = simulation_of(
        "time.end = '1 us'\n[material.rubber]\ndensity = 1000.0\neos = { model = 'linear', bulk_modulus = '2 GPa' }\n"
        "strength = { model = 'elastic', shear_modulus = '1 MPa' }\n",
        particles_on(Space::plane_strain, lattices, 1000.0));
    Watch watch;
    auto warnings = watch.look(simulation.particles(), simulation.settings(), {});
    CHECK(watch.look(simulation.particles(), simulation.settings(), {}).empty());  // told of each of them
    return warnings;
  };
  CHECK(warnings_of(4).size() == 4);
  const auto of_many = warnings_of(51);
  REQUIRE(of_many.size() == 1);
  CHECK(of_many[0].name == "locking");
  CHECK_THAT(of_many[0].text, Catch::Contains("of 51 bodies") && Catch::Contains("ball0"));
}

TEST_CASE("Watch: a lattice has no clumps, however fine it is pressed") {
  auto particles =
      particles_on(Space::plane_strain, {{"square", "metal", spacing, {0.0, 0.0}, {12, 12}, {0.0, 0.0}}}, density);
  auto simulation = simulation_of("time.end = 1.0\n" + metal, std::move(particles));
  CHECK(clumped_part(simulation.particles(), simulation.particles().bodies()[0]) == 0.0);
  auto pressed = simulation.particles();
  for (auto& x : pressed.reals(Field::position)) x *= 0.25;
  CHECK(clumped_part(pressed, pressed.bodies()[0]) == 1.0);  // the density has not followed
  for (auto& rho : pressed.reals(Field::density)) rho *= 16.0;
  CHECK(clumped_part(pressed, pressed.bodies()[0]) == 0.0);
}

TEST_CASE("Reference configuration: one that is turned inside out ends the run by that name") {
  // Without viscosity both halves run through each other.
  auto particles = particles_on(Space::line, {{"bar", "metal", spacing, {0.0}, {40}, {0.0}}}, density);
  for (std::size_t i = 0; i < particles.count(); ++i) particles.reals(Field::velocity)[i] = i < 20 ? 2e5 : -2e5;
  auto simulation = simulation_of(
      "time.end = 1.0\nscheme.type = 'total-lagrangian'\nviscosity = { alpha = 0.0, beta = 0.0 }\n" + metal,
      std::move(particles));
  CHECK_THROWS_WITH(take_steps(simulation, 100), Catch::StartsWith("negative-jacobian: "));
}

TEST_CASE("Time step: one that collapses ends the run by that name") {
  // Bars meet so fast that a step takes them half a support into each other, where a contact of absurd stiffness acts.
  auto simulation = simulation_of(
      "time.end = 1.0\nscheme.type = 'total-lagrangian'\ncontact.factor = 1e20\n" + metal,
      particles_on(Space::line,
                   {{"left", "metal", spacing, {0.0}, {20}, {16e3}}, {"right", "metal", spacing, {23e-3}, {20}, {0.0}}},
                   density));
  CHECK_THROWS_WITH(take_steps(simulation, 1000), Catch::StartsWith("dt-collapse: "));
}

TEST_CASE("Energy: one that runs away ends the run by that name") {
  const auto bar_at = [](double speed) {
    return simulation_of("time.end = 1.0\n" + metal,
                         particles_on(Space::line, {{"bar", "metal", spacing, {0.0}, {40}, {speed}}}, density));
  };
  auto flying = bar_at(100.0);
  auto ledger = flying.ledger();
  ledger.kinetic *= 10.0;
  CHECK_NOTHROW(flying.note(ledger));
  ledger.kinetic *= 1.2;
  CHECK_THROWS_WITH(flying.note(ledger), Catch::StartsWith("energy-runaway: "));
  // A bar that hardly moves at the start and is pressed: what it exchanges later is no error, nor a part of that.
  auto slow = bar_at(1e-6);
  ledger = slow.ledger();
  ledger.kinetic += 1.05;
  ledger.internal -= 1.0;
  CHECK_NOTHROW(slow.note(ledger));
}
