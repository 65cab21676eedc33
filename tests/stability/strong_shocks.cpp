// Gas at its extremes: the wall that heats, shocks of a hundred times the speed of sound, expansion into nothing.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "physics/eos/eos.hpp"
#include "run/watch.hpp"
#include "support/lattice.hpp"
#include "support/riemann.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

struct Case {
  std::string name, scene;
  double ratio;
};
const Case eulerian{"eulerian", "scheme.type = 'eulerian'\n", 2.0};
const Case msph{"msph", "scheme = { type = 'msph', forces = 'adjoint' }\nsmoothing.kernel = 'truncated-gaussian'\n",
                1.5};
const Case pm{"godunov-pm", "scheme.type = 'godunov-pm'\n", 2.0};
const Case split1{"godunov-split 1", "scheme = { type = 'godunov-split', order = 1 }\n", 2.0};
const Case split2{"godunov-split 2", "scheme = { type = 'godunov-split', order = 2 }\n", 2.0};
const Case split2s{"godunov-split 2 two-shock",
                   "scheme = { type = 'godunov-split', order = 2, riemann = { model = 'two-shock' } }\n", 2.0};

std::string gas(double heat_ratio) {
  return fmt::format("[material.gas]\ndensity = 1.0\neos = {{ model = 'ideal-gas', heat_ratio = {} }}\n", heat_ratio);
}

/// Of a gas without pressure that runs into a wall at x = 0 with speed one: specific energy over exact, 1/2.
struct Wall {
  double at_wall = 0.0;  ///< of the particle at the wall
  double extent = 0.0;   ///< particles from the wall on that are hotter than 5 % too much
};

Wall wall_heating(const Case& c, int count) {
  const double spacing = 1.0 / count;
  auto p =
      particles_on(Space::line, {{"gas", "gas", spacing, {0.5 * spacing}, {count}, {-1.0}, nullptr, c.ratio}}, 1.0);
  p.allocate(Field::specific_internal_energy);
  std::ranges::fill(p.reals(Field::specific_internal_energy), 1e-6);
  auto simulation =
      simulation_of("symmetry.wall = { axis = 'x' }\ntime.end = 0.6\n" + c.scene + gas(5.0 / 3.0), std::move(p));
  run_to_the_end(simulation);
  const auto e = by_id(simulation.particles(), Field::specific_internal_energy);
  Wall wall{e[0] / 0.5, 0.0};
  while (e[static_cast<std::size_t>(wall.extent)] > 0.5 * 1.05) ++wall.extent;
  return wall;
}

/// A tube of gas of heat ratio 1.4, a body to each side of x = 0, until `end`.
struct Tube {
  FluidState left, right;
  double end;
};

Simulation tube_run(const Case& c, const Tube& tube, double spacing) {
  const int half = static_cast<int>(std::lround(1.0 / spacing));
  std::vector<Lattice> bodies{
      {"left", "gas", spacing, {-1.0 + 0.5 * spacing}, {half}, {tube.left.velocity}, nullptr, c.ratio}};
  if (tube.right.density > 0.0)
    bodies.push_back({"right", "gas", spacing, {0.5 * spacing}, {half}, {tube.right.velocity}, nullptr, c.ratio});
  auto p = particles_on(Space::line, bodies, 1.0);
  p.allocate(Field::specific_internal_energy);
  for (std::size_t i = 0; i < p.count(); ++i) {
    const auto& state = p.reals(Field::position)[i] < 0.0 ? tube.left : tube.right;
    p.reals(Field::density)[i] = state.density;
    p.reals(Field::mass)[i] = state.density * spacing;
    p.reals(Field::specific_internal_energy)[i] = state.energy;
  }
  auto simulation = simulation_of(fmt::format("time.end = {}\n", tube.end) + c.scene + gas(1.4), std::move(p));
  run_to_the_end(simulation);
  return simulation;
}

std::string warned(const Simulation& simulation) {
  Watch watch;
  watch.look(simulation.particles(), simulation.settings().materials, simulation.scheme().warnings());
  return fmt::format("{}", fmt::join(watch.names(), " "));
}

}  // namespace

TEST_CASE("Wall heating: the gas at a wall is too hot, over a fixed number of particles") {
  for (const auto& c : {eulerian, msph, pm, split1, split2}) {
    Wall coarse, fine;
    try {
      coarse = wall_heating(c, 100);
      fine = wall_heating(c, 400);
    } catch (const RunError& e) {
      WARN(c.name << std::string(e.what()).substr(0, 80));
      continue;
    }
    WARN(fmt::format("{}: at the wall {:.3f} and {:.3f} of the exact energy, over {} and {} particles", c.name,
                     coarse.at_wall, fine.at_wall, coarse.extent, fine.extent));
  }
}

TEST_CASE("Strong shock: Mach 100") {
  // Two streams of gas of sound speed 1/100.
  const double c0 = 0.01, e0 = c0 * c0 / (1.4 * 0.4);
  const Tube streams{{1.0, 0.83325, e0, 0.0}, {1.0, -0.83325, e0, 0.0}, 0.5};
  for (const auto& c : {eulerian, Case{"eulerian 1.2", eulerian.scene, 1.2}, Case{"eulerian 4", eulerian.scene, 4.0},
                        Case{"eulerian corr", "scheme = { type = 'eulerian', correction = 'mixed' }\n", 2.0}, msph, pm,
                        split1, split2, split2s})
    for (double sp : {0.01, 0.0025}) {
      try {
        const auto simulation = tube_run(c, streams, sp);
        double density = 0.0, pressure = 0.0, velocity = 0.0, number = 0.0;
        const auto& p = simulation.particles();
        for (std::size_t i = 0; i < p.count(); ++i) {
          const double x = std::abs(p.reals(Field::position)[i]);
          if (x < 0.02 || x > 0.06) continue;
          density += p.reals(Field::density)[i];
          pressure += p.reals(Field::pressure)[i];
          velocity = std::max(velocity, std::abs(p.reals(Field::velocity)[i]));
          ++number;
        }
        struct {
          double density, pressure;
        } behind{6.0 / (1.0 + 5.0e-4), 1.0 * c0 * c0 / 1.4 * (7.0 * 1e4 - 1.0) / 6.0};
        WARN(fmt::format("{}: density {:.3f}, pressure {:.3f} of exact, velocity {:.3f}, drift {:.1e}, {} steps {}",
                         c.name, density / number / behind.density, pressure / number / behind.pressure, velocity,
                         simulation.energy_drift(simulation.ledger()), simulation.steps(), warned(simulation)));
      } catch (const RunError& e) {
        WARN(c.name << std::string(e.what()).substr(0, 60));
      }
    }
}

TEST_CASE("Vacuum: gas expands into nothing") {
  // Its edge runs at 2c/(γ-1).
  const double e0 = 1.0 / (1.4 * 0.4);
  const Tube tube{{1.0, 0.0, e0, 0.0}, {0.0, 0.0, 0.0, 0.0}, 0.15};
  for (const auto& c : {Case{"eulerian 1.4", eulerian.scene, 1.4}, eulerian, Case{"eulerian 4", eulerian.scene, 4.0},
                        Case{"eulerian 8", eulerian.scene, 8.0}}) {
    for (const double spacing : {0.01, 0.0025}) {
      const auto simulation = tube_run(c, tube, spacing);
      const auto x = by_id(simulation.particles(), Field::position), v = by_id(simulation.particles(), Field::velocity),
                 e = by_id(simulation.particles(), Field::specific_internal_energy);
      double error = 0.0;
      for (std::size_t i = 0; i < x.size(); ++i)
        if (x[i] > -0.4) {
          const double xi = x[i] / tube.end, exact = std::clamp(2.0 / 2.4 * (1.0 + xi), 0.0, 5.0);
          error += std::abs(v[i] - exact) * spacing;
        }
      WARN(fmt::format("{}, δ = {}: edge at {:.2f} of 5, velocity error {:.4f}, least energy {:.3e} {}", c.name,
                       spacing, v.back(), error, *std::ranges::min_element(e), warned(simulation)));
    }
  }
}
