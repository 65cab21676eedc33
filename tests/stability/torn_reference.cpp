// What a reference configuration cannot describe: layers that slip past each other, and pieces that meet again.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "run/hourglass_share.hpp"
#include "run/too_near.hpp"
#include "support/lattice.hpp"
#include "support/said.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

constexpr double spacing = 1e-3, density = 2785.0;

/// Two layers of one body, the upper one moving along the lower one; no viscosity of shear would let them slip.
constexpr double soft_yield = 1e6, slip_speed = 100.0;
constexpr int across = 30, high = 16;

struct Slip {
  double speed;  ///< of the upper layer against the lower one at the end, over that at the start
  double share;  ///< of the energy that kernels do not see
  std::set<std::string> names;
};

Slip slipped(const std::string& scheme, double spacings) {
  auto particles =
      particles_on(Space::plane_strain, {{"layers", "soft", spacing, {0.0, 0.0}, {across, high}, {0.0, 0.0}}}, density);
  const auto upper = [](double y) { return y > (0.5 * high - 0.5) * spacing; };
  for (std::size_t i = 0; i < particles.count(); ++i)
    particles.reals(Field::velocity)[2 * i] =
        upper(particles.reals(Field::position)[2 * i + 1]) ? 0.5 * slip_speed : -0.5 * slip_speed;
  std::vector<bool> is_upper;
  for (const double y : by_id(particles, Field::position)) is_upper.push_back(upper(y));
  auto simulation = simulation_of(
      fmt::format("time.end = {}\nviscosity = {{ model = 'monaghan', alpha = 0.0, beta = 2.0 "
                  "}}\n{}[material.soft]\ndensity = 2785.0\neos = {{ model = 'linear', bulk_modulus = 79e9 }}\n"
                  "strength = {{ model = 'perfectly-plastic', shear_modulus = 27.6e9, yield_stress = {} }}\n",
                  spacings * spacing / slip_speed, scheme, soft_yield),
      std::move(particles));
  run_to_the_end(simulation);
  Slip slip{0.0, 0.0, {}};
  slip.names = said(simulation);
  slip.share = hourglass_share(simulation.particles(), simulation.particles().bodies()[0],
                               simulation.settings().materials.at("soft"));
  const auto v = by_id(simulation.particles(), Field::velocity);
  for (std::size_t i = 0; i < v.size() / 2; ++i)
    slip.speed += (is_upper[2 * i + 1] ? 1.0 : -1.0) * v[2 * i] / (0.25 * static_cast<double>(v.size()) * slip_speed);
  return slip;
}

/// Two blocks of one body that are further apart than kernels reach, as cracks leave them, meet at 200 m/s.
Simulation meeting_pieces(const std::string& contact) {
  constexpr int side = 10, gap = 5;
  auto particles = particles_on(
      Space::plane_strain,
      {{"pieces",
        "metal",
        spacing,
        {0.0, 0.0},
        {2 * side + gap, side},
        {0.0, 0.0},
        [](const double* x) { return x[0] < (side - 0.5) * spacing || x[0] > (side + gap - 0.5) * spacing; }}},
      density);
  for (std::size_t i = 0; i < particles.count(); ++i)
    particles.reals(Field::velocity)[2 * i] =
        particles.reals(Field::position)[2 * i] < (side + 0.5 * gap) * spacing ? 100.0 : -100.0;
  auto simulation =
      simulation_of("time.end = 60e-6\nscheme.type = 'total-lagrangian'\n" + contact +
                        "[material.metal]\ndensity = 2785.0\neos = { model = 'linear', bulk_modulus = 79e9 }\n"
                        "strength = { model = 'elastic', shear_modulus = 27.6e9 }\n",
                    std::move(particles));
  run_to_the_end(simulation);
  return simulation;
}

}  // namespace

TEST_CASE("Reference configuration: layers that slip past each other are no linear motion, and the run says so") {
  // The soft metal lets the layers slip, so that what slows them is its yield stress, (Y/√3) w t against the momentum
  // of a layer, and the smearing over a kernel. A control of zero-energy modes takes slip for one of them.
  constexpr double spacings = 8.0;
  const double slowed = 2.0 * soft_yield / std::sqrt(3.0) * spacings / (density * 0.5 * high * slip_speed * slip_speed);
  const auto by = [&](const std::string& scheme) {
    auto slip = slipped("scheme = { type = " + scheme + " }\n", spacings);
    WARN(fmt::format("{}: speed {:.3f} (yield alone: {:.3f}), hourglass share {:.3f}", scheme, slip.speed, 1.0 - slowed,
                     slip.share));
    return slip;
  };
  const auto bonded = by("'total-lagrangian'"), held = by("'total-lagrangian', hourglass_control = 0.1"),
             eulerian = by("'eulerian'");
  CHECK(bonded.names.contains("hourglass"));
  CHECK(held.names.contains("hourglass"));
  CHECK(eulerian.names.empty());
  CHECK(bonded.speed > eulerian.speed);
  CHECK(held.speed < bonded.speed);
}

TEST_CASE("Reference configuration: pieces that cracks have parted run into each other, and the run says so") {
  for (const std::string contact : {"", "contact.itself = true\n"}) {
    const auto simulation = meeting_pieces(contact);
    WARN(fmt::format("{:.0f} % of the particles are too near {}",
                     100.0 * interpenetrated_part(simulation.particles(), simulation.particles().bodies()[0]),
                     contact));
    CHECK(said(simulation).contains("interpenetration") == contact.empty());
  }
}
