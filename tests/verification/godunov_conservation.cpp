// The Godunov schemes conserve energy and momentum to round-off in every step, whatever the state: the time-split
// Godunov paper, eq. 28-35.
#include <catch2/catch.hpp>

#include <algorithm>

#include "support/impact.hpp"
#include "support/lattice.hpp"
#include "support/random_step.hpp"

using namespace tektite;

namespace {

/// The godunov schemes with everything that changes a pair's formulas, in any space ...
const std::vector<std::string> schemes{
    "scheme = { type = 'godunov-pm' }\n",
    "scheme = { type = 'godunov-split', order = 1 }\n",
    "scheme = { type = 'godunov-split', order = 2 }\n",
    "scheme = { type = 'godunov-split', order = 2, riemann = { model = 'two-shock' }, limiter = { model = 'van-leer' } "
    "}\n",
    "scheme = { type = 'godunov-split', riemann = { model = 'exact' }, limiter = { model = 'monotonized-central' } }\n",
    "scheme = { type = 'godunov-split', order = 1, correction = 'mixed' }\n",
    "scheme = { type = 'godunov-split', correction = 'mixed', correction_limit = 10.0, riemann = { model = 'two-shock' "
    "}, "
    "limiter = { model = 'van-leer' } }\n",
};
/// ... and in those that are not thin.
const std::vector<std::string> thick{
    "scheme = { type = 'godunov-split', order = 2, splitting = 'strang' }\n",
    "scheme = { type = 'godunov-split', splitting = 'strang', correction = 'mixed', correction_limit = 10.0 }\n",
};
constexpr std::array spaces{Space::line, Space::plane_strain, Space::plane_stress, Space::solid};

std::vector<std::string> schemes_in(Space space) {
  auto all = schemes;
  if (space != Space::plane_stress) all.insert(all.end(), thick.begin(), thick.end());
  return all;
}

/// The two bodies of the impact in a state that is random in everything that a state has.
Particles random_particles(Space space, unsigned seed) {
  auto particles = test::impact_particles(space);
  test::Random random(seed);
  particles.allocate(Field::specific_internal_energy);
  particles.allocate(Field::deviatoric_stress);
  for (auto& x : particles.reals(Field::position)) x += random.between(-0.3, 0.3) * test::impact_spacing;
  for (auto& v : particles.reals(Field::velocity)) v += random.between(-300.0, 300.0);
  for (auto& rho : particles.reals(Field::density)) rho *= random.between(0.95, 1.1);
  for (auto& e : particles.reals(Field::specific_internal_energy)) e = random.between(0.0, 1e6);
  for (auto& s : particles.reals(Field::deviatoric_stress)) s = random.between(-2e8, 2e8);
  return particles;
}

}  // namespace

TEST_CASE("Godunov schemes: a step of a random state conserves energy and momentum to round-off", "[godunov]") {
  for (const auto space : spaces)
    for (const auto& scheme : schemes_in(space))
      for (const unsigned seed : {1u, 2u, 3u}) {
        INFO(name_of(space) << " " << scheme << seed);
        auto simulation = test::simulation_of(scheme + test::impact_scene, random_particles(space, seed));
        const auto before = simulation.ledger();
        simulation.step();
        const auto after = simulation.ledger();
        // Something happened: kinetic energy became internal energy, or the other way round.
        CHECK(std::abs(after.kinetic - before.kinetic) > 1e-6 * before.kinetic);
        // Some hundreds of particles with some tens of neighbours, each pair rounded to 1e-16.
        CHECK(after.total() == Approx(before.total()).epsilon(1e-14));
        CHECK(simulation.momentum_drift(after) < 1e-14);
      }
}

TEST_CASE("Godunov schemes: so does an impact with plastic flow, to the end", "[godunov]") {
  constexpr int steps = 200;
  for (const auto space : spaces)
    for (const auto& scheme : schemes_in(space)) {
      INFO(name_of(space) << " " << scheme);
      auto simulation = test::simulation_of(scheme + test::impact_scene, test::impact_particles(space));
      test::take_steps(simulation, steps);
      const auto ledger = simulation.ledger();
      CHECK(ledger.plastic > 0.01 * ledger.total());
      CHECK(std::abs(simulation.energy_drift(ledger)) < steps * 1e-15);  // round-off does not add up in one direction
      CHECK(simulation.momentum_drift(ledger) < steps * 1e-15);
    }
}

// What a contact presses is held in balance by pressure and shear, and with the correction these act one after the
// other, along ways that differ from that of the place.
TEST_CASE("Godunov schemes: energy is kept while a contact presses elastic bodies", "[godunov][contact]") {
  constexpr double spacing = 0.5e-3, side = 12 * spacing;
  constexpr double speed = 10.0;  // m/s
  for (const std::string scheme : {"order = 1", "order = 2", "order = 2, correction = 'mixed'"}) {
    INFO(scheme);
    auto simulation = test::simulation_of(
        "time.end = '8 us'\ncontact.begins = 'at-faces'\nscheme = { type = 'godunov-split', " + scheme +
            " }\n[material.steel]\ndensity = 7850.0\neos = { model = 'linear', bulk_modulus = '160 GPa' }\n"
            "strength = { model = 'elastic', shear_modulus = '80 GPa' }\n",
        test::particles_on(Space::plane_strain,
                           {{"left", "steel", spacing, {0.0, 0.0}, {12, 12}, {speed, 0.0}},
                            {"middle", "steel", spacing, {side, 0.0}, {12, 12}, {0.0, 0.0}},
                            {"right", "steel", spacing, {2.0 * side, 0.0}, {12, 12}, {-speed, 0.0}}},
                           7850.0));
    double stored = 0.0;
    while (!simulation.finished()) {
      simulation.step();
      stored = std::max(stored, simulation.ledger().contact);
    }
    const auto ledger = simulation.ledger();
    CHECK(stored > 0.01 * ledger.total());
    // The potential of the contact is kept as a leapfrog keeps it.
    CHECK(std::abs(simulation.energy_drift(ledger)) < 2e-3);
  }
}
