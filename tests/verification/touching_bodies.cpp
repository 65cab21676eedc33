// Bodies that touch at the start: at rest they stay, shocks go through their faces as through one body, sound as
// acoustics asks, and faces slide.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "support/lattice.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

constexpr double spacing = 1e-3, density = 2785.0;  // m, kg/m³
const std::string contact = "contact = { model = 'kernel-penalty' }\n";
const std::string elastic =
    "[material.metal]\ndensity = 2785.0\neos = { model = 'linear', bulk_modulus = '79 GPa' }\n"
    "strength = { model = 'elastic', shear_modulus = '27.6 GPa' }\n";
const std::string yielding =
    "[material.metal]\ndensity = 2785.0\n"
    "eos = { model = 'mie-grueneisen', bulk_sound_speed = 5328.0, hugoniot_slope = 1.338, grueneisen = 2.0 }\n"
    "strength = { model = 'perfectly-plastic', shear_modulus = '27.6 GPa', yield_stress = '0.3 GPa' }\n";
const std::vector<std::string> schemes{"type = 'total-lagrangian'", "type = 'eulerian'",
                                       "type = 'adaptle', conversion = 'strain', conversion_strain = 0.5",
                                       "type = 'godunov-split'"};

double largest(const Particles& particles, Field field) {
  double most = 0.0;
  for (const auto value : particles.reals(field)) most = std::max(most, std::abs(value));
  return most;
}

/// Moves and turns a plane scene by an angle about the origin, so that no lattice lies along an axis any more.
void turn(Particles& particles, double angle) {
  for (const auto field : {Field::position, Field::velocity}) {
    const auto values = particles.reals(field);
    for (std::size_t i = 0; i < particles.count(); ++i) {
      const double x = values[2 * i], y = values[2 * i + 1];
      values[2 * i] = std::cos(angle) * x - std::sin(angle) * y;
      values[2 * i + 1] = std::sin(angle) * x + std::cos(angle) * y;
    }
  }
}

/// Layers of so many particles on each other in the first direction, all of one metal; the first flies at `speed`.
Particles layers(Space space, const std::vector<int>& thickness, double speed) {
  std::vector<Lattice> bodies;
  const auto d = static_cast<std::size_t>(dimensions_of(space));
  double from = 0.5 * spacing;
  for (std::size_t k = 0; k < thickness.size(); ++k) {
    Lattice layer{
        "layer" + std::to_string(k), "metal", spacing, std::vector<double>(d, 0.5 * spacing), std::vector<int>(d, 6),
        std::vector<double>(d, 0.0)};
    layer.first[0] = from;
    layer.count[0] = thickness[k];
    if (k == 0) layer.velocity[0] = speed;
    from += thickness[k] * spacing;
    bodies.push_back(layer);
  }
  return particles_on(space, bodies, density);
}

struct FreeSurface {
  double arrival = 0.0;   ///< of half the speed, s
  double velocity = 0.0;  ///< mean between 1 and 4 µs after that, m/s
};

/// What the last particle along a line does.
FreeSurface free_surface(const std::string& scheme, Particles particles, double speed) {
  auto run = simulation_of("time.end = '20 us'\n" + scheme, std::move(particles));
  FreeSurface found;
  double from = 0.0, last = 0.0;
  while (!run.finished()) {
    run.step();
    const auto x = by_id(run.particles(), Field::position), v = by_id(run.particles(), Field::velocity);
    const double t = run.time();
    if (found.arrival == 0.0 && v.back() > 0.5 * speed) found.arrival = t;
    if (found.arrival == 0.0 || t < found.arrival + 1e-6) continue;
    if (from == 0.0) {
      from = t;
      last = x.back();
    }
    if (t > found.arrival + 4e-6) {
      found.velocity = (x.back() - last) / (t - from);
      return found;
    }
  }
  return found;
}

}  // namespace

TEST_CASE("Touching bodies: plates on each other at rest stay at rest, in every space and direction", "[contact]") {
  for (const auto space : {Space::line, Space::plane_strain, Space::solid})
    for (const auto& scheme : schemes) {
      INFO(name_of(space) << " " << scheme);
      auto particles = layers(space, {4, 6, 2}, 0.0);
      if (space == Space::plane_strain) turn(particles, 0.5);
      auto run =
          simulation_of("time.end = '1 s'\nscheme = { " + scheme + " }\n" + contact + elastic, std::move(particles));
      take_steps(run, 30);
      CHECK(largest(run.particles(), Field::velocity) < 1e-9);  // round-off of deformation gradients
      CHECK(run.ledger().contact == 0.0);
      CHECK_FALSE(run.contact_time().has_value());
    }
}

TEST_CASE("Touching bodies: particles on both faces that agree do not drive the bodies apart", "[contact]") {
  for (const std::string scheme : {"total-lagrangian", "eulerian"}) {
    INFO(scheme);
    auto run = simulation_of("time.end = '1 s'\nscheme.type = '" + scheme + "'\n" + contact + elastic,
                             particles_on(Space::plane_strain,
                                          {{"left", "metal", spacing, {0.0, 0.0}, {6, 6}, {0.0, 0.0}},
                                           {"right", "metal", spacing, {5 * spacing, 0.0}, {6, 6}, {0.0, 0.0}}},
                                          density));
    take_steps(run, 200);
    CHECK(largest(run.particles(), Field::velocity) < 1e-9);
    CHECK(run.ledger().contact == 0.0);
  }
}

TEST_CASE("Touching bodies: bodies that are pressed together push from the first moment, and keep energy and momentum",
          "[contact]") {
  for (const std::string scheme : {"type = 'total-lagrangian'", "type = 'eulerian'"}) {
    INFO(scheme);
    auto particles = layers(Space::plane_strain, {8, 6, 8}, 50.0);
    turn(particles, 0.5);
    auto run =
        simulation_of("time.end = '20 us'\nscheme = { " + scheme + " }\n" + contact + elastic, std::move(particles));
    const double before = run.ledger().total();
    double stored = 0.0, worst = 0.0;
    while (!run.finished()) {
      run.step();
      stored = std::max(stored, run.ledger().contact);
      worst = std::max(worst, std::abs(run.energy_drift(run.ledger())));
    }
    WARN(fmt::format("{}: stores {:.3f} of the energy, drift {:.1e}", scheme, stored / before, worst));
    CHECK(stored > 1e-3 * before);
    CHECK(worst < 2e-3);
    CHECK(run.momentum_drift(run.ledger()) < 1e-10);
  }
}

TEST_CASE("Touching bodies: a shock goes through a plate of three layers as through one", "[contact][shock]") {
  // Eulerian kernels without correction are cut off at the faces: each costs about the way through a spacing.
  for (const auto& [scheme, tolerance] : {std::pair<std::string, double>{"total-lagrangian", 0.02}, {"eulerian", 0.06}})
    for (const double speed : {1000.0, 3000.0}) {
      const auto text = "scheme.type = '" + scheme + "'\n" + contact + yielding;
      const auto whole = free_surface(text, layers(Space::line, {60, 90}, speed), speed),
                 parts = free_surface(text, layers(Space::line, {60, 30, 30, 30}, speed), speed);
      WARN(fmt::format("{} at {} m/s: arrives after {:.3f} and {:.3f} us, leaves at {:.1f} and {:.1f} m/s", scheme,
                       speed, 1e6 * whole.arrival, 1e6 * parts.arrival, whole.velocity, parts.velocity));
      CHECK(parts.arrival == Approx(whole.arrival).epsilon(tolerance));
      CHECK(parts.velocity == Approx(whole.velocity).epsilon(tolerance));
    }
}

TEST_CASE("Touching bodies: a wave goes from ceramic into steel as acoustics asks", "[contact]") {
  // A flyer of ceramic on a tile of it, which lies on steel: behind the tile the velocity is V Z_c/(Z_c + Z_s).
  constexpr double speed = 50.0;
  constexpr double ceramic_density = 3890.0, ceramic_modulus = 231e9 + 4.0 / 3.0 * 152e9;
  constexpr double steel_density = 7850.0, steel_modulus = 166.7e9 + 4.0 / 3.0 * 76.9e9;
  const double ceramic = std::sqrt(ceramic_density * ceramic_modulus), steel = std::sqrt(steel_density * steel_modulus);
  const double velocity = speed * ceramic / (ceramic + steel), stress = velocity * steel;
  const double crossing = 200.0 * spacing * std::sqrt(ceramic_density / ceramic_modulus);
  for (const std::string scheme : {"total-lagrangian", "eulerian"}) {
    INFO(scheme);
    auto particles = particles_on(Space::line,
                                  {{"flyer", "ceramic", spacing, {0.5 * spacing}, {200}, {speed}},
                                   {"tile", "ceramic", spacing, {200.5 * spacing}, {100}, {0.0}},
                                   {"backing", "steel", spacing, {300.5 * spacing}, {200}, {0.0}}},
                                  ceramic_density);
    for (std::size_t i = particles.bodies()[2].range.begin; i < particles.bodies()[2].range.end; ++i) {
      particles.scalars(Field::density)[i] = steel_density;
      particles.scalars(Field::mass)[i] = steel_density * spacing;
    }
    auto run =
        simulation_of(fmt::format("time.end = {}\nscheme.type = '{}'\n", 1.2 * crossing, scheme) + contact +
                          "[material.ceramic]\ndensity = 3890.0\neos = { model = 'linear', bulk_modulus = '231 GPa' }\n"
                          "strength = { model = 'elastic', shear_modulus = '152 GPa' }\n"
                          "[material.steel]\ndensity = 7850.0\neos = { model = 'linear', bulk_modulus = '166.7 GPa' }\n"
                          "strength = { model = 'elastic', shear_modulus = '76.9 GPa' }\n",
                      std::move(particles));
    run_to_the_end(run);
    const auto v = by_id(run.particles(), Field::velocity), p = by_id(run.particles(), Field::pressure);
    const auto s = by_id(run.particles(), Field::deviatoric_stress);
    const std::size_t width = s.size() / v.size();
    double mean_velocity = 0.0, mean_stress = 0.0;
    constexpr std::size_t from = 310, to = 340;
    for (std::size_t i = from; i < to; ++i) {
      mean_velocity += v[i] / (to - from);
      mean_stress += (p[i] - s[width * i]) / (to - from);
    }
    WARN(fmt::format("{}: velocity {:.4f}, stress {:.4f} of the exact ones", scheme, mean_velocity / velocity,
                     mean_stress / stress));
    CHECK(mean_velocity == Approx(velocity).epsilon(0.01));
    CHECK(mean_stress == Approx(stress).epsilon(0.01));
  }
}

TEST_CASE("Touching bodies: a block slides on a plate without being thrown off or held", "[contact]") {
  constexpr double speed = 100.0;
  for (const std::string scheme : {"total-lagrangian", "eulerian"}) {
    INFO(scheme);
    const Lattice plate{"plate", "metal", spacing, {0.5 * spacing, -5.5 * spacing}, {50, 6}, {0.0, 0.0}};
    const Lattice block{"block", "metal", spacing, {5.5 * spacing, 0.5 * spacing}, {16, 8}, {speed, 0.0}};
    auto particles = particles_on(Space::plane_strain, {plate, block}, density);
    turn(particles, 0.3);
    auto run = simulation_of("time.end = '150 us'\nscheme.type = '" + scheme + "'\n" + contact + elastic,
                             std::move(particles));
    run_to_the_end(run);
    const auto v = by_id(run.particles(), Field::velocity);
    double along = 0.0, across = 0.0;
    for (std::size_t i = 300; i < 428; ++i) {
      along += (std::cos(0.3) * v[2 * i] + std::sin(0.3) * v[2 * i + 1]) / 128.0;
      across += (std::cos(0.3) * v[2 * i + 1] - std::sin(0.3) * v[2 * i]) / 128.0;
    }
    WARN(fmt::format("{}: along {:.6f}, across {:.6f} of the speed", scheme, along / speed, across / speed));
    CHECK(along == Approx(speed).epsilon(1e-3));
    CHECK(std::abs(across) < 1e-3 * speed);
  }
}
