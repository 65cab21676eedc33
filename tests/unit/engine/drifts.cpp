// What a run says of energy, momentum and time step while it goes on.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/impact.hpp"
#include "support/lattice.hpp"
#include "support/temporary_folder.hpp"

using namespace tektite;

namespace {

/// A block of metal at a density 1 % above that at rest, which the ledger counts as no energy at all.
Simulation squeezed_block() {
  const std::string scene =
      "time.end = 1.0\n[material.metal]\ndensity = 2785.0\neos = { model = 'linear', bulk_modulus = '79 GPa' }\n";
  auto particles =
      test::particles_on(Space::plane_strain, {{"block", "metal", 1e-3, {0.0, 0.0}, {16, 16}, {0.0, 0.0}}}, 2785.0);
  std::ranges::fill(particles.reals(Field::density), 1.01 * 2785.0);
  return test::simulation_of(scene, std::move(particles));
}

/// Steps with a line of the history after each.
void take_noted_steps(Simulation& simulation, int steps) {
  for (int k = 0; k < steps; ++k) {
    simulation.step();
    simulation.note(simulation.ledger());
  }
}

Simulation resumed_from(Simulation& simulation) {
  const test::TemporaryFolder folder;
  write_snapshot(simulation.save({}), folder.file("middle.h5"));
  auto snapshot = read_snapshot(folder.file("middle.h5"));
  auto document = Document::parse(snapshot.scene, "middle.h5");
  auto settings = read_run_settings(document);
  return Simulation(std::move(snapshot), std::move(settings), true);
}

}  // namespace

TEST_CASE("Drift: a run that starts without energy is measured by what is at play in it", "[drift]") {
  auto simulation = squeezed_block();
  CHECK(simulation.energy_drift(simulation.ledger()) == 0.0);
  double most = 0.0;  // J/m, kinetic
  for (int k = 0; k < 60; ++k) {
    take_noted_steps(simulation, 1);
    most = std::max(most, simulation.ledger().kinetic);
  }
  const auto now = simulation.ledger();
  REQUIRE(now.kinetic < 0.9 * most);  // it rings, so that what is at play now is not what was
  REQUIRE(now.total() != 0.0);
  const double drift = simulation.energy_drift(now);
  // All kinetic energy came out of the internal energy: neither can be much larger than the other.
  CHECK(std::abs(drift) <= std::abs(now.total()) / most);
  CHECK(std::abs(drift) > 0.5 * std::abs(now.total()) / most);
}

TEST_CASE("Drift: it is the same after a restart, to the last bit, wherever the largest energy was met", "[drift]") {
  for (const int before : {20, 60}) {
    auto unbroken = squeezed_block();
    take_noted_steps(unbroken, before);
    auto resumed = resumed_from(unbroken);
    take_noted_steps(unbroken, 40);
    take_noted_steps(resumed, 40);
    CHECK(unbroken.energy_drift(unbroken.ledger()) == resumed.energy_drift(resumed.ledger()));
  }
}

TEST_CASE("Drift: of a run with energy at its start it is that of the start", "[drift]") {
  auto simulation = test::simulation_of(test::impact_scene, test::impact_particles(Space::plane_strain));
  const double initial = simulation.ledger().total();
  take_noted_steps(simulation, 20);
  const auto now = simulation.ledger();
  CHECK(simulation.energy_drift(now) == (now.total() - initial) / initial);
}

TEST_CASE("Drift: the momentum that an anvil takes up is none that the scheme has lost", "[drift]") {
  const std::string scheme = GENERATE("eulerian", "total-lagrangian");
  INFO(scheme);
  const std::string scene = "scheme.type = '" + scheme + "'\nanvil.axis = 'x'\n" + test::impact_scene;
  const double d = test::impact_spacing;
  auto simulation = test::simulation_of(
      scene,
      test::particles_on(Space::plane_strain, {{"bar", "metal", d, {0.0, 0.5 * d}, {20, 8}, {-200.0, 30.0}}}, 2785.0));
  const double before = simulation.ledger().momentum[0];
  test::take_steps(simulation, 40);
  const auto now = simulation.ledger();
  REQUIRE(std::abs(now.momentum[0] - before) > 0.1 * std::abs(before));
  CHECK(simulation.momentum_drift(now) < 1e-12);
}

TEST_CASE("Time step: the particle that set it is named by its id, also where the step has put it elsewhere") {
  auto simulation = test::simulation_of(test::impact_scene, test::impact_particles(Space::plane_strain));
  int moved = 0;
  for (int k = 0; k < 400; ++k) {
    const auto index = simulation.scheme().stable_step().particle;
    const auto id = simulation.particles().integers(Field::id)[index];
    simulation.step();
    CHECK(simulation.limiting_particle() == id);
    moved += simulation.particles().integers(Field::id)[index] != id;
  }
  CHECK(moved > 0);
}
