// Zero-energy modes of kernels of the reference configuration: the control that costs linear motions nothing, and the
// detector that tells a run that has them.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <numbers>

#include "run/hourglass_share.hpp"
#include "run/watch.hpp"
#include "stability/largest_step.hpp"
#include "stability/lattice_cases.hpp"
#include "support/lattice.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

constexpr double spacing = 1e-3, density = 2785.0, shear = 27.6e9;
const double wave_speed = std::sqrt((metal_modulus + 4.0 / 3.0 * shear) / density);

std::string metal_scene(double control, const std::string& other = {}, double courant = 0.25) {
  return fmt::format(
      "scheme = {{ type = 'total-lagrangian', hourglass_control = {}, courant = {} }}\n{}[material.metal]\ndensity = "
      "2785.0\n"
      "eos = {{ model = 'linear', bulk_modulus = 79e9 }}\nstrength = {{ model = 'elastic', shear_modulus = 27.6e9 }}\n",
      control, courant, other);
}

/// Minus one to one, without order.
double disorder(std::size_t k) { return (static_cast<double>(k * 7919 % 1009) - 504.0) / 504.0; }

/// A disc or ball of metal with this velocity at X.
template <class Velocity>
Particles moving_ball(Space space, double radius, const Velocity& velocity) {
  auto particles = particles_on(space, {ball(dimensions_of(space), spacing, radius)}, density);
  const auto d = static_cast<std::size_t>(particles.dimensions());
  for (std::size_t i = 0; i < particles.count(); ++i)
    velocity(&particles.reals(Field::position)[i * d], &particles.reals(Field::velocity)[i * d], i);
  return particles;
}

std::vector<double> first_acceleration(const std::string& scene, Particles particles) {
  auto simulation = simulation_of("time.end = 1.0\n" + scene, std::move(particles));
  simulation.step();
  return by_id(simulation.particles(), Field::acceleration);
}

/// Largest change that the control makes to the accelerations of the first step, over c²/δ times the velocity over c.
double first_change(const Particles& particles) {
  const auto with = first_acceleration(metal_scene(0.5), particles),
             without = first_acceleration(metal_scene(0.0), particles);
  double largest = 0.0, fastest = 0.0;
  for (std::size_t k = 0; k < with.size(); ++k) largest = std::max(largest, std::abs(with[k] - without[k]));
  for (const double v : particles.reals(Field::velocity)) fastest = std::max(fastest, std::abs(v));
  return largest / (wave_speed * fastest / spacing);
}

/// Frequency of the shortest wave by the control alone, times δ/c: every second neighbour moves against a particle, and
/// ω² = 4 k/ρ Σ V (-W'/r) over these.
double zigzag_frequency(double control, double ratio) {
  double sum = 0.0;
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y)
      if (x % 2 != 0) {
        const double r = std::hypot(x, y);
        sum -= kernel_slope<CubicSpline, 2>(r, ratio) / r;
      }
  return std::sqrt(4.0 * control * shear / density * sum) / wave_speed;
}

/// A breathing square whose neighbours have been set against each other: strained by about a percent and, without
/// control, by zero-energy modes.
Simulation noisy_square(double control, double noise) {
  constexpr int side = 20;
  auto particles =
      particles_on(Space::plane_strain, {{"square", "metal", spacing, {0.0, 0.0}, {side, side}, {0.0, 0.0}}}, density);
  for (std::size_t i = 0; i < particles.count(); ++i) {
    const auto* x = &particles.reals(Field::position)[2 * i];
    auto* v = &particles.reals(Field::velocity)[2 * i];
    const auto column = std::lround(x[0] / spacing), row = std::lround(x[1] / spacing);
    const double sign = (column + row) % 2 == 0 ? 1.0 : -1.0;
    for (int k = 0; k < 2; ++k)
      v[k] = wave_speed * (0.01 * (x[k] / (0.5 * (side - 1) * spacing) - 1.0) + (k == 0 ? sign * noise : 0.0));
  }
  auto simulation = simulation_of(fmt::format("time.end = {}\n", 60.0 * spacing / wave_speed) + metal_scene(control),
                                  std::move(particles));
  run_to_the_end(simulation);
  return simulation;
}

double share_of(const Simulation& simulation) {
  return hourglass_share(simulation.particles(), simulation.particles().bodies()[0],
                         simulation.settings().materials.at("metal"));
}

}  // namespace

TEST_CASE("Hourglass control: a linear motion feels none of it, at surfaces neither") {
  const auto linear = [](const double* x, double* v, std::size_t) {
    for (int k = 0; k < 2; ++k) v[k] = 1e4 * ((k == 0 ? 3.0 : -7.0) * x[0] + (k == 0 ? 5.0 : 2.0) * x[1]);
  };
  CHECK(first_change(moving_ball(Space::plane_strain, 6.5, linear)) < 1e-12);
  const auto noise = [](const double*, double* v, std::size_t i) {
    for (std::size_t k = 0; k < 2; ++k) v[k] = 100.0 * disorder(2 * i + k);
  };
  CHECK(first_change(moving_ball(Space::plane_strain, 6.5, noise)) > 1e-2);
}

TEST_CASE("Hourglass warning: a body that flies as one has nothing of them, however far it has come") {
  auto particles =
      particles_on(Space::plane_strain, {{"square", "metal", spacing, {0.0, 0.0}, {10, 10}, {333.0, -77.0}}}, density);
  auto simulation = simulation_of("time.end = 2e-4\n" + metal_scene(0.0), std::move(particles));
  run_to_the_end(simulation);
  CHECK(share_of(simulation) == 0.0);
}

TEST_CASE("Hourglass control: momentum and angular momentum are kept, and the energy as the step grows shorter") {
  const auto drift = [](double courant, bool& sane) {
    auto particles = moving_ball(Space::plane_strain, 6.5, [](const double*, double* v, std::size_t i) {
      for (std::size_t k = 0; k < 2; ++k) v[k] = 10.0 * disorder(2 * i + k);
    });
    auto simulation = simulation_of(
        fmt::format("time.end = {}\n{}", 40.0 * spacing / wave_speed, metal_scene(0.5, no_viscosity, courant)),
        std::move(particles));
    run_to_the_end(simulation);
    const auto ledger = simulation.ledger();
    sane = simulation.momentum_drift(ledger) < 1e-12 && ledger.hourglass > 0.02 * ledger.kinetic;
    WARN(fmt::format("C = {}: energy drift {:.2e}, momentum drift {:.1e}, stored {:.3f} of the kinetic energy", courant,
                     simulation.energy_drift(ledger), simulation.momentum_drift(ledger),
                     ledger.hourglass / ledger.kinetic));
    return std::abs(simulation.energy_drift(ledger));
  };
  bool sane = false;
  const double coarse = drift(0.25, sane);
  CHECK(sane);
  const double fine = drift(0.125, sane);
  CHECK(sane);
  CHECK(fine < 0.3 * coarse);  // of second order at least
}

TEST_CASE("Hourglass control: gives the shortest waves the frequency that its energy asks for") {
  for (const double control : {0.0, 0.05, 0.5}) {
    const auto settings = lattice_settings(
        "plane-strain",
        no_viscosity + fmt::format("scheme = {{ type = 'total-lagrangian', hourglass_control = {} }}\n", control));
    const Amplification step(settings, stressed(settings, 1.4, 0.0), short_step);
    const auto growth = step.growth({std::numbers::pi, 0.0});
    WARN(fmt::format("control {}: frequency {:.4f} c/δ, predicted {:.4f}, growth {:.1e}", control, growth.frequency,
                     zigzag_frequency(control, 1.4), growth.rate));
    CHECK(growth.frequency == Approx(zigzag_frequency(control, 1.4)).epsilon(1e-3).margin(1e-5));
    CHECK(growth.rate < growing);
    const auto viscous = lattice_settings(
        "plane-strain", fmt::format("scheme = {{ type = 'total-lagrangian', hourglass_control = {} }}\n", control));
    const auto largest = largest_stable_step(viscous, stressed(viscous, 1.4, 0.0), 4);
    WARN(fmt::format("  stable up to C = {:.2f}", 0.25 * largest.share));
    CHECK(largest.share > 1.0);
  }
}

TEST_CASE("Hourglass: a run that has zero-energy modes says so, and the control mends it") {
  Watch watch;
  const auto without = noisy_square(0.0, 2e-3);
  const auto warnings = watch.look(without.particles(), without.settings(), {});
  const auto with = noisy_square(0.1, 2e-3), healthy = noisy_square(0.0, 0.0);
  WARN(fmt::format("share: {:.3f} without, {:.3f} with control, {:.4f} without noise", share_of(without),
                   share_of(with), share_of(healthy)));
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].name == "hourglass");
  CHECK(Watch().look(with.particles(), with.settings(), {}).empty());
  CHECK(Watch().look(healthy.particles(), healthy.settings(), {}).empty());
}

TEST_CASE("Hourglass: what rounding leaves in a body that flies undisturbed is none") {
  auto simulation = simulation_of(
      fmt::format("time.end = {}\n", 600.0 * spacing / wave_speed) + metal_scene(0.0),
      particles_on(Space::plane_strain,
                   {{"square", "metal", spacing, {4.5 * spacing, 0.3 * spacing}, {20, 12}, {-0.05 * wave_speed, 0.0}}},
                   density));
  run_to_the_end(simulation);
  CHECK(share_of(simulation) == 0.0);
}
