// The time step in use beside the largest stable one, for every scheme, by the same means: the waves of a lattice.
#include "stability/largest_step.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "stability/lattice_cases.hpp"
#include "support/lattice.hpp"

using namespace tektite;
using namespace tektite::test;

TEST_CASE("Time step: that in use is below the largest stable one for every scheme") {
  for (const std::string scheme :
       {"scheme = { type = 'eulerian' }\n", "scheme = { type = 'eulerian', correction = 'mixed' }\n",
        "scheme = { type = 'total-lagrangian' }\n", "scheme = { type = 'adaptle', conversion = 'none' }\n",
        "scheme = { type = 'godunov-pm' }\n", "scheme = { type = 'godunov-split', order = 1 }\n",
        "scheme = { type = 'godunov-split', order = 2 }\n",
        "scheme = { type = 'msph' }\nsmoothing.kernel = 'truncated-gaussian'\n"}) {
    const auto settings = lattice_settings("line", scheme);
    const auto largest = largest_stable_step(settings, stressed(settings, 1.4, 0.0), 8);
    WARN(fmt::format("{}C = {:g} in use, stable up to {:.2f}; {:.2f} δ/c", scheme, settings.scheme.courant,
                     settings.scheme.courant * largest.share, largest.in_use * largest.share));
    CHECK(largest.share > 1.0);
    CHECK(largest.share < 64.0);  // all of them are explicit
  }
}

TEST_CASE("Time step: steps beyond the largest stable one go wild, those of three quarters of it do not") {
  const auto settings = lattice_settings("line", "scheme = { type = 'total-lagrangian' }\n");
  const auto largest = largest_stable_step(settings, stressed(settings, 1.4, 0.0), 8);
  const auto speed_after = [&](double share) {  // m/s, of all wavelengths at 1 mm/s at the start
    auto particles = particles_on(Space::line, {{"bar", "metal", 1e-3, {0.0}, {40}, {0.0}}}, 2785.0);
    for (std::size_t i = 0; i < particles.count(); ++i)
      particles.reals(Field::velocity)[i] = 1e-3 * (static_cast<double>(i * 7919 % 101) - 50.0) / 50.0;
    Profile profile;
    const auto scheme = make_scheme({particles, profile, settings.materials, settings.scheme, {}});
    scheme->start();
    const double dt = share * scheme->stable_step().dt;
    for (int k = 0; k < 300; ++k) scheme->step(dt);
    double fastest = 0.0;
    for (const double v : particles.reals(Field::velocity)) fastest = std::max(fastest, std::abs(v));
    return std::isfinite(fastest) ? fastest : std::numeric_limits<double>::infinity();
  };
  // The map takes half the viscosity of a wave that presses together; with all of it runs go wild from 0.85 on.
  CHECK(speed_after(0.75 * largest.share) < 2e-3);
  CHECK(speed_after(1.1 * largest.share) > 1.0);
}

TEST_CASE("Time step: cold gas, which has no sound speed, does not pass other gas or a plane in a step") {
  const std::string scheme = GENERATE("'eulerian'", "'godunov-split', order = 1, riemann = { model = 'exact' }");
  const bool plane = GENERATE(true, false);
  INFO(scheme << (plane ? ", a symmetry plane" : ", two bodies"));
  constexpr double delta = 1e-3, speed = 1000.0;
  std::vector<Lattice> bodies{{"right", "gas", delta, {10.5 * delta}, {50}, {-speed}}};
  if (!plane) bodies.insert(bodies.begin(), {"left", "gas", delta, {-59.5 * delta}, {50}, {speed}});
  auto simulation = simulation_of(
      "time.end = '40 us'\nscheme = { type = " + scheme + " }\n" + (plane ? "symmetry.wall.axis = 'x'\n" : "") +
          "[material.gas]\ndensity = 1.0\neos = { model = 'ideal-gas', heat_ratio = 1.6667 }\n",
      particles_on(Space::line, bodies, 1.0));
  simulation.step();
  CHECK(simulation.last_step().reason == StepLimit::meeting);
  run_to_the_end(simulation);
  // The gas is four times as dense behind the shock: in 30 µs that takes 40 of its 50 mm, and heat of all their motion.
  const auto ledger = simulation.ledger();
  WARN(fmt::format("{:.2f} of the energy is heat", ledger.internal / ledger.total()));
  CHECK(ledger.internal == Approx(0.8 * ledger.total()).epsilon(0.2));
}
