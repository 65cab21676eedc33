// An elastic bar that rings for very many steps: what its frequency, its amplitude and its energy do.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <numbers>

#include "stability/lattice_cases.hpp"
#include "support/lattice.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

constexpr double spacing = 1e-3, density = 2785.0;
const double wave_speed = std::sqrt((79e9 + 4.0 / 3.0 * 27.6e9) / density);

std::string scheme(const std::string& type, double courant, double alpha) {
  return fmt::format(
      "scheme = {{ type = '{}', courant = {} }}\nviscosity = {{ model = 'monaghan', alpha = {}, beta = 0.0 }}\n", type,
      courant, alpha);
}

struct Ringing {
  double first_frequency = 0.0, last_frequency = 0.0;  ///< in the first and the last tenth, times 2 L/c
  double amplitude = 0.0;                              ///< of the last tenth over that of the first one
  double drift = 0.0;                                  ///< of the energy
};

/// Free bar in its first mode, by the difference of the momenta of its halves.
Ringing ring(const std::string& settings, int steps) {
  constexpr int count = 20;
  auto p = particles_on(Space::line, {{"bar", "metal", spacing, {0.5 * spacing}, {count}, {0.0}}}, density);
  for (std::size_t i = 0; i < p.count(); ++i)
    p.reals(Field::velocity)[i] =
        1e-4 * wave_speed * std::cos(std::numbers::pi * p.reals(Field::position)[i] / (count * spacing));
  auto simulation = simulation_of("time.end = 1e9\n" + settings +
                                      "[material.metal]\ndensity = 2785.0\n"
                                      "eos = { model = 'linear', bulk_modulus = 79e9 }\n"
                                      "strength = { model = 'elastic', shear_modulus = 27.6e9 }\n",
                                  std::move(p));
  const auto difference = [&] {
    const auto v = simulation.particles().reals(Field::velocity);
    double sum = 0.0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += v[i] * (i < v.size() / 2 ? 1.0 : -1.0);
    return sum;
  };
  Ringing ringing;
  double at_first = 0.0;
  for (int part = 0; part < 10; ++part) {
    double before = difference(), then = simulation.time(), first = 0.0, last = 0.0, largest = 0.0;
    int periods = -1;
    for (int k = 0; k < steps / 10; ++k) {
      simulation.step();
      const double now = difference(), t = simulation.time();
      if (before < 0.0 && now >= 0.0) {
        last = then + (t - then) * before / (before - now);
        if (periods < 0) first = last;
        ++periods;
      }
      largest = std::max(largest, std::abs(now));
      before = now;
      then = t;
    }
    const double frequency = periods / (last - first) * 2.0 * count * spacing / wave_speed;
    if (part == 0) ringing.first_frequency = frequency, at_first = largest;
    ringing.last_frequency = frequency;
    ringing.amplitude = largest / at_first;
  }
  ringing.drift = simulation.energy_drift(simulation.ledger());
  return ringing;
}

void show(const std::string& settings, const Ringing& r) {
  WARN(fmt::format("{}frequency {:.8f}, then {:.8f}; amplitude {:.6f}, energy drift {:.2e}", settings,
                   r.first_frequency, r.last_frequency, r.amplitude, r.drift));
}

}  // namespace

TEST_CASE("Oscillation: without viscosity the energy grows by a part of the third power of the time step") {
  for (const std::string type : {"total-lagrangian", "eulerian"}) {
    const auto growth = [&](double courant, double alpha) {
      const auto settings = lattice_settings("line", scheme(type, courant, alpha));
      return fastest_growth(Amplification(settings, stressed(settings, 1.4, 0.0)), waves_of(1, 40)).growth.rate;
    };
    const double whole = growth(0.2, 0.0), half = growth(0.1, 0.0);
    WARN(fmt::format("{}: fastest wave {:.1e} c/δ at C = 0.2, {:.1e} at 0.1, {:.1e} with α = 0.03", type, whole, half,
                     growth(0.2, 0.03)));
    CHECK(whole / half == Approx(8.0).epsilon(0.1));
    CHECK(growth(0.2, 0.03) < 1e-9);
    const auto coarse = ring(scheme(type, 0.2, 0.0), 5000), fine = ring(scheme(type, 0.1, 0.0), 10000);
    show(type + ", C = 0.2: ", coarse);
    show(type + ", C = 0.1: ", fine);
    CHECK(fine.drift < coarse.drift / 8.0);
  }
}

TEST_CASE("Oscillation: neither frequency nor amplitude drift in twenty thousand short steps") {
  for (const std::string type : {"total-lagrangian", "eulerian"}) {
    const auto ringing = ring(scheme(type, 0.1, 0.0), 20000);
    show(type + ": ", ringing);
    CHECK(ringing.last_frequency == Approx(ringing.first_frequency).epsilon(1e-4));  // of counting whole periods in it
    CHECK(ringing.amplitude == Approx(1.0).epsilon(2e-3));
    CHECK(std::abs(ringing.drift) < 2e-3);
  }
}

TEST_CASE("Oscillation: neither frequency nor amplitude drift in a million short steps", "[.long]") {
  for (const std::string type : {"total-lagrangian", "eulerian"}) {
    const auto ringing = ring(scheme(type, 0.05, 0.0), 1000000);
    show(type + ": ", ringing);
    CHECK(ringing.last_frequency == Approx(ringing.first_frequency).epsilon(1e-5));
    CHECK(ringing.amplitude == Approx(1.0).epsilon(0.01));
    CHECK(std::abs(ringing.drift) < 0.01);  // what the run would tell of: energy-drift
  }
}
