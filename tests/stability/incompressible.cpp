// Elasticity as Poisson's ratio nears a half: what the time step costs, and whether bending locks.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "support/lattice.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

constexpr double spacing = 1e-3, density = 1000.0, shear = 1e7;

struct Bending {
  double frequency;  ///< of a cantilever's first mode, over that of a thin beam, 1/s over 1/s
  double steps;
};

/// A cantilever is struck and swings: from the first time that its end comes back.
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
  return {0.5 * 3.14159265358979 / time / thin, static_cast<double>(simulation.steps())};
}

}  // namespace

TEST_CASE("Near-incompressible elasticity: bending") {
  for (const std::string scheme :
       {"scheme.type = 'total-lagrangian'\n", "scheme = { type = 'total-lagrangian', hourglass_control = 0.1 }\n",
        "scheme.type = 'eulerian'\n"})
    for (const double poisson : {0.3, 0.49, 0.499}) {
      const auto b = bending(scheme, poisson);
      WARN(fmt::format("{}ν = {}: {:.4f} of the thin beam's frequency, {} steps a quarter", scheme, poisson,
                       b.frequency, b.steps));
    }
}
