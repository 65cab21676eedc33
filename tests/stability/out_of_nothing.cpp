// Motion out of nothing: a limiter that steepens waves pays for it with internal energy. It keeps the total energy, so
// it has a name of its own.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "support/lattice.hpp"
#include "support/said.hpp"

using namespace tektite;

namespace {

constexpr double d = 1e-4;  // spacing, m

const std::string metal =
    "time.end = '1 ms'\n[material.metal]\ndensity = 2785.0\neos = { model = 'linear', bulk_modulus = '79 GPa' }\n";
const std::string shear = "strength = { model = 'elastic', shear_modulus = '27.6 GPa' }\n";

/// A bar with free ends and a pulse of 1 m/s in its middle.
Simulation ringing_bar(const std::string& scheme, const std::string& strength = shear) {
  constexpr int count = 100;
  auto particles = test::particles_on(Space::line, {{"bar", "metal", d, {0.5 * d}, {count}, {0.0}}}, 2785.0);
  for (std::size_t i = 0; i < particles.count(); ++i) {
    const double x = (particles.reals(Field::position)[i] / (count * d) - 0.5) / 0.8;
    particles.reals(Field::velocity)[i] = std::abs(x) < 0.5 ? std::pow(std::cos(std::numbers::pi * x), 4) : 0.0;
  }
  return test::simulation_of(scheme + metal + strength, std::move(particles));
}

}  // namespace

TEST_CASE("Energy debt: superbee makes an elastic bar ring ever louder, other limiters hardly do, and it is told") {
  struct Case {
    std::string scheme;
    bool grows, told;
  };
  const std::string split = "type = 'godunov-split', limiter = { model = ";
  for (const auto& [scheme, grows, told] :
       {Case{split + "'sweby', beta = 2 }", true, true}, Case{split + "'van-leer' }", false, true},
        Case{split + "'van-leer' }, correction = 'mixed'", false, false},
        Case{split + "'sweby', beta = 1 }", false, false}, Case{"type = 'eulerian'", false, false},
        Case{"type = 'total-lagrangian'", false, false}}) {
    INFO(scheme);
    auto simulation = ringing_bar("scheme = { " + scheme + " }\n");
    const double before = simulation.ledger().kinetic;
    for (int k = 0; k < 12000; ++k) simulation.step();
    CHECK((simulation.ledger().kinetic > 1.5 * before) == grows);
    CHECK(std::abs(simulation.energy_drift(simulation.ledger())) < 1e-2);
    CHECK(test::said(simulation).contains("energy-debt") == told);
  }
}

TEST_CASE("Energy debt: by Strang's splitting a bar with strength rings louder by itself, one without does not") {
  const auto grows = [](const std::string& strength) {
    auto simulation = ringing_bar("scheme = { type = 'godunov-split', splitting = 'strang', order = 1 }\n", strength);
    const double before = simulation.ledger().kinetic;
    bool louder = false;
    for (int k = 0; k < 12000 && !louder; ++k) {
      simulation.step();
      louder = simulation.ledger().kinetic > 1.5 * before;
    }
    CHECK(test::said(simulation).contains("energy-debt") == louder);
    return louder;
  };
  CHECK(grows(shear));
  CHECK_FALSE(grows(""));
}
