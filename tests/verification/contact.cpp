// Contact: bodies push each other, keep momentum and energy, and let go again.
#include <catch2/catch.hpp>
#include <map>

#include "support/lattice.hpp"

using namespace tektite;

namespace {

constexpr double spacing = 1e-3;  // m
constexpr double speed = 100.0;   // m/s

/// An elastic block flies against one at rest; in the end they have parted.
std::string scene_of(const std::string& scheme) {
  return "scheme.type = '" + scheme + "'\n" +
         "contact.model = 'kernel-penalty'\n"
         "viscosity.alpha = 0.0\nviscosity.beta = 0.0\n"
         "time.end = '60 us'\n"
         "[material.metal]\ndensity = 2785.0\n"
         "eos = { model = 'linear', bulk_modulus = '79 GPa' }\n"
         "strength = { model = 'elastic', shear_modulus = '27.6 GPa' }\n";
}

Simulation collision(const std::string& scheme, double velocity, const std::string& more = {}) {
  const test::Lattice flying{"flying", "metal", spacing, {-20 * spacing, 0.0}, {16, 8}, {velocity, 0.0}};
  const test::Lattice resting{"resting", "metal", spacing, {0.0, 0.0}, {16, 8}, {0.0, 0.0}};
  return test::simulation_of(more + scene_of(scheme),
                             test::particles_on(Space::plane_strain, {flying, resting}, 2785.0));
}

double mean_velocity(const Particles& particles, std::size_t body) {
  const auto& range = particles.bodies()[body].range;
  double sum = 0.0;
  for (std::size_t i = range.begin; i < range.end; ++i) sum += particles.reals(Field::velocity)[2 * i];
  return sum / static_cast<double>(range.size());
}

}  // namespace

TEST_CASE("Contact: two elastic blocks meet, store energy between them, and part", "[contact]") {
  for (const std::string scheme : {"eulerian", "total-lagrangian"}) {
    INFO(scheme);
    auto run = collision(scheme, speed);
    const auto before = run.ledger();
    double stored = 0.0, worst = 0.0;
    while (!run.finished()) {
      run.step();
      const auto now = run.ledger();
      stored = std::max(stored, now.contact);
      worst = std::max(worst, std::abs(run.energy_drift(now)));
    }
    const auto after = run.ledger();
    CHECK(run.contact_time());
    CHECK(stored > 1e-3 * before.kinetic);
    CHECK(after.contact == 0.0);  // they have let go of each other
    CHECK(mean_velocity(run.particles(), 1) > 0.5 * speed);
    CHECK(mean_velocity(run.particles(), 0) < 0.5 * speed);
    // The contact's energy is that of a potential and the leapfrog keeps it to second order in the step.
    CHECK(worst < 2e-3);
    CHECK(run.momentum_drift(after) < 1e-12);
  }
}

TEST_CASE("Contact: pieces of one body push each other as two bodies do, where the scene says so", "[contact]") {
  // The lattice of both blocks with the gap between them: one body, or two.
  const auto pieces = [](const std::string& more) {
    const auto in_block = [](const double* x) { return x[0] < -4.5 * spacing || x[0] > -0.5 * spacing; };
    auto p = test::particles_on(
        Space::plane_strain, {{"both", "metal", spacing, {-20 * spacing, 0.0}, {36, 8}, {0.0, 0.0}, in_block}}, 2785.0);
    for (std::size_t i = 0; i < p.count(); ++i)
      if (p.reals(Field::position)[2 * i] < -4.5 * spacing) p.reals(Field::velocity)[2 * i] = speed;
    return test::simulation_of(more + scene_of("total-lagrangian"), std::move(p));
  };
  auto two = collision("total-lagrangian", speed);
  auto one = pieces("contact.itself = true\n"), blind = pieces("");
  for (auto* run : {&two, &one, &blind}) test::run_to_the_end(*run);

  // By place at the start, since the two runs number their particles in other orders.
  const auto sorted = [](const Particles& p) {
    std::map<std::pair<double, double>, std::pair<double, double>> velocities;
    const auto x = p.reals(Field::reference_position), v = p.reals(Field::velocity);
    for (std::size_t i = 0; i < p.count(); ++i)
      velocities[{std::round(x[2 * i] / spacing), std::round(x[2 * i + 1] / spacing)}] = {v[2 * i], v[2 * i + 1]};
    return velocities;
  };
  const auto expected = sorted(two.particles()), found = sorted(one.particles()), passed = sorted(blind.particles());
  REQUIRE(found.size() == expected.size());
  for (const auto& [place, velocity] : expected) {
    CHECK(found.at(place).first == Approx(velocity.first).margin(1e-8 * speed));  // round-off, over the collision
    CHECK(found.at(place).second == Approx(velocity.second).margin(1e-8 * speed));
    CHECK(passed.at(place).first == Approx(place.first < -4.0 ? speed : 0.0).margin(1e-8 * speed));
  }
}

TEST_CASE("Contact: what it stores follows from places and materials, not from how dense a region is at the start",
          "[contact]") {
  const auto stored = [](const std::string& scheme, double density) {
    auto p = test::particles_on(Space::plane_strain,
                                {{"left", "metal", spacing, {-10.0 * spacing, 0.0}, {8, 8}, {1e6, 0.0}},
                                 {"right", "metal", spacing, {0.0, 0.0}, {8, 8}, {0.0, 0.0}}},
                                2785.0);
    for (auto i = p.bodies()[1].range.begin; i < p.bodies()[1].range.end; ++i) {
      p.reals(Field::mass)[i] *= density;
      p.reals(Field::density)[i] *= density;
    }
    auto run = test::simulation_of(scene_of(scheme), std::move(p));
    run.step();  // so fast that nothing but the left body moves on the way into reach
    return run.ledger().contact;
  };
  for (const std::string scheme : {"eulerian", "total-lagrangian"}) {
    INFO(scheme);
    REQUIRE(stored(scheme, 1.0) > 0.0);
    CHECK(stored(scheme, 0.9) == Approx(stored(scheme, 1.0)).epsilon(1e-3));
  }
}

TEST_CASE("Contact: where it is stiffer than the bodies it limits the time step", "[contact]") {
  auto stiff = collision("total-lagrangian", 20.0 * speed, "contact.factor = 1000.0\n");
  auto soft = collision("total-lagrangian", 20.0 * speed);
  bool limited = false;
  while (!stiff.finished() && !limited) {
    stiff.step();
    limited = stiff.last_step().reason == StepLimit::contact;
  }
  CHECK(limited);
  while (soft.time() < stiff.time()) soft.step();
  CHECK(soft.last_step().reason != StepLimit::contact);
}

// A bar without strength at 500 m/s strikes an equal one: half of it is what the shock in either brings. While the
// particles at the faces, which the contact presses, find places that suit its force, the shock sent is 5 % weaker.
TEST_CASE("Contact: the shock behind it is as strong by the Godunov schemes, whatever the time step", "[contact]") {
  constexpr double flight = 500.0;
  const auto struck = [](const std::string& scheme, double courant) {
    const test::Lattice flying{"flying", "metal", spacing, {-154 * spacing}, {150}, {flight}};
    const test::Lattice resting{"resting", "metal", spacing, {0.0}, {150}, {0.0}};
    auto run = test::simulation_of("scheme = { " + scheme + ", courant = " + std::to_string(courant) +
                                       " }\ncontact.model = 'kernel-penalty'\ntime.end = '26 us'\n"
                                       "[material.metal]\ndensity = 2785.0\n"
                                       "eos = { model = 'stiffened-gas', bulk_sound_speed = 5328, grueneisen = 2.0 }\n",
                                   test::particles_on(Space::line, {flying, resting}, 2785.0));
    test::run_to_the_end(run);
    const auto& range = run.particles().bodies()[1].range;
    double sum = 0.0;
    for (std::size_t i = range.begin + 20; i < range.begin + 60; ++i) sum += run.particles().reals(Field::velocity)[i];
    return std::pair{sum / 40.0, run.energy_drift(run.ledger())};
  };
  for (const std::string scheme :
       {"type = 'godunov-pm'", "type = 'godunov-split', order = 1", "type = 'godunov-split'",
        "type = 'godunov-split', splitting = 'strang'", "type = 'godunov-split', correction = 'mixed'"}) {
    INFO(scheme);
    const auto [coarse, coarse_drift] = struck(scheme, 0.5);
    const auto [fine, fine_drift] = struck(scheme, 0.125);
    CHECK(coarse == Approx(0.5 * flight).epsilon(0.06));
    CHECK(fine == Approx(coarse).epsilon(0.02));
    CHECK(std::abs(coarse_drift) < 1e-3);
    CHECK(std::abs(fine_drift) < 1e-4);
  }
}
