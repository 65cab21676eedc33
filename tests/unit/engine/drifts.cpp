// What a run says of energy, momentum and time step while it goes on.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "run/angular_momentum.hpp"
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

TEST_CASE("Drift: the angular momentum of what spins is told, whatever moves the observer", "[drift]") {
  const double d = 1e-3, spin = 2e4;  // m, rad/s
  for (const double speed : {0.0, 1000.0})
    for (const auto& [correction, kept] : {std::pair{"mixed", true}, {"none", false}}) {
      INFO(speed << " m/s, " << correction);
      auto particles =
          test::particles_on(Space::plane_strain, {{"block", "metal", d, {0.1, 0.2}, {16, 16}, {0.0, 0.0}}}, 2785.0);
      for (std::size_t i = 0; i < particles.count(); ++i) {
        const auto x = particles.reals(Field::position).subspan(2 * i, 2);
        const auto v = particles.reals(Field::velocity).subspan(2 * i, 2);
        v[0] = speed - spin * (x[1] - 0.2 - 7.5 * d);
        v[1] = spin * (x[0] - 0.1 - 7.5 * d);
      }
      auto simulation = test::simulation_of(
          fmt::format("scheme = {{ type = 'eulerian', correction = '{}' }}\nviscosity = {{ alpha = 0.0, beta = 0.0 }}\n"
                      "time.end = 1.0\n[material.metal]\ndensity = 2785.0\n"
                      "eos = {{ model = 'linear', bulk_modulus = '79 GPa' }}\n"
                      "strength = {{ model = 'elastic', shear_modulus = '27.6 GPa' }}\n",
                      correction),
          std::move(particles));
      const auto before = AngularMomentum()(simulation.particles());
      REQUIRE(before.size() == 1);
      // A square of n x n particles: Σ m r² = N m d² (n² - 1)/6, all of which turns.
      CHECK(before[0] == Approx(256 * 2785.0 * d * d * d * d * 255.0 / 6.0 * spin).epsilon(1e-9));
      CHECK(largest_angular_momentum_of(simulation.particles()) == Approx(before[0]).epsilon(1e-9));
      test::take_steps(simulation, 100);
      const auto drift = simulation.angular_momentum_drift();
      REQUIRE(drift.has_value());
      CHECK((*drift < 1e-10) == kept);
      auto resumed = resumed_from(simulation);
      CHECK(resumed.angular_momentum_drift() == drift);
    }
}

TEST_CASE("Drift: what flies through space as a whole has none of the angular momentum, whatever round-off turns",
          "[drift]") {
  const double d = 1e-3;
  for (const std::string scheme : {"eulerian", "total-lagrangian"}) {
    INFO(scheme);
    // Not a rectangle, so that the sums of no two directions cancel.
    const auto inside = [](const double* x) { return x[0] + 0.3 * x[1] < 10e-3; };
    auto simulation = test::simulation_of(
        "scheme.type = '" + scheme +
            "'\ntime.end = 1.0\n[material.metal]\ndensity = 2785.0\n"
            "eos = { model = 'linear', bulk_modulus = '79 GPa' }\n"
            "strength = { model = 'elastic', shear_modulus = '27.6 GPa' }\n",
        test::particles_on(Space::plane_strain,
                           {{"block", "metal", d, {0.0, 0.0}, {16, 16}, {4000.0, -7000.0}, inside}}, 2785.0));
    test::take_steps(simulation, 50);
    CHECK(simulation.angular_momentum_drift().value() < 1e-4);
  }
}

TEST_CASE("Drift: there is none of the angular momentum where planes or clamps turn what moves", "[drift]") {
  const double d = test::impact_spacing;
  const auto drift_of = [&](Space space, const std::string& more, bool clamped) {
    auto particles = test::impact_particles(space);
    if (clamped) {
      particles.allocate(Field::clamped);
      particles.integers(Field::clamped)[0] = 1;
    }
    auto simulation = test::simulation_of(more + test::impact_scene, std::move(particles));
    return simulation.angular_momentum_drift();
  };
  CHECK(drift_of(Space::plane_strain, "", false).has_value());
  CHECK_FALSE(drift_of(Space::plane_strain, "", true).has_value());
  CHECK_FALSE(
      drift_of(Space::plane_strain, fmt::format("symmetry.middle = {{ axis = 'y', at = {} }}\n", -20.0 * d), false));
  CHECK(drift_of(Space::solid, fmt::format("symmetry.middle = {{ axis = 'y', at = {} }}\n", -20.0 * d), false));
  CHECK_FALSE(drift_of(Space::line, "", false));
}

TEST_CASE("Drift: the momentum that clamped particles take up is none that the scheme has lost", "[drift]") {
  auto particles = test::impact_particles(Space::plane_strain);
  particles.allocate(Field::clamped);
  auto simulation = test::simulation_of(test::impact_scene, particles);
  CHECK(simulation.momentum_drift({0.0, 0.0, 0.0, 0.0, 0.0, {1e3, 0.0}}) > 0.0);  // nobody is clamped yet
  const auto& target = particles.bodies().back();
  particles.integers(Field::clamped)[target.range.end - 1] = 1;
  auto held = test::simulation_of(test::impact_scene, particles);
  const double before = held.ledger().momentum[0];
  test::take_steps(held, 100);
  const auto now = held.ledger();
  REQUIRE(std::abs(now.momentum[0] - before) > 1e-6 * std::abs(before));
  CHECK(held.momentum_drift(now) == 0.0);
}

TEST_CASE("Time step: the particle that set it is named by its id, also where the step has put it elsewhere") {
  auto simulation = test::simulation_of(test::impact_scene, test::impact_particles(Space::plane_strain));
  int moved = 0;
  for (int k = 0; k < 400; ++k) {
    const auto id = simulation.scheme().stable_step().particle;
    const auto ids = simulation.particles().integers(Field::id);
    const auto index = static_cast<std::size_t>(std::ranges::find(ids, id) - ids.begin());
    simulation.step();
    CHECK(simulation.limiting_particle() == id);
    moved += simulation.particles().integers(Field::id)[index] != id;
  }
  CHECK(moved > 0);
}
