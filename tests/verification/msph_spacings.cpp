// Bodies of unlike spacing strike each other by msph: with adjoint forces the momentum is kept to round-off, and the
// energy as well as with equal spacings; strong forces keep it as they do there.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "support/lattice.hpp"

using namespace tektite;

namespace {

constexpr double speed = 2000.0, fine = 1e-4, half_width = 1e-3;  // m/s, m

struct Drift {
  double energy, momentum;  ///< as parts of those at the start
};

/// A plate of 1 mm strikes one of 2 mm, whose particles are `ratio` times as coarse; along x, or along the axis.
Drift after_impact(Space space, const std::string& scheme, double ratio) {
  const double coarse = ratio * fine;
  const bool rings = space == Space::axisymmetric;
  const auto body = [&](double spacing, double first, double width) {
    test::Lattice lattice{"", "metal", spacing, {first}, {}, {}};
    const auto across = static_cast<int>(std::lround(width / spacing));
    const auto along = static_cast<int>(std::lround((first < 0.0 ? 1e-3 : 2e-3) / spacing));
    const double v = first < 0.0 ? speed : 0.0;
    if (space == Space::line) {
      lattice.count = {along};
      lattice.velocity = {v};
    } else if (rings) {
      lattice.first = {0.5 * spacing, first};
      lattice.count = {across, along};
      lattice.velocity = {0.0, v};
    } else {
      lattice.first = {first, 0.5 * spacing - width};
      lattice.count = {along, 2 * across};
      lattice.velocity = {v, 0.0};
    }
    lattice.ratio = 1.5;
    return lattice;
  };
  auto flyer = body(fine, 0.5 * fine - 1e-3, half_width), target = body(coarse, 0.5 * coarse, 2.0 * half_width);
  flyer.body = "flyer";
  target.body = "target";
  auto particles = test::particles_on(space, {flyer, target}, 2785.0);
  if (rings)
    for (std::size_t i = 0; i < particles.count(); ++i)
      particles.scalars(Field::mass)[i] *= 2.0 * M_PI * particles.reals(Field::position)[2 * i];
  auto run = test::simulation_of(
      "scheme = { type = 'msph', " + scheme +
          " }\nsmoothing.kernel = 'truncated-gaussian'\n[material.metal]\n"
          "density = 2785.0\n"
          "eos = { model = 'mie-grueneisen', bulk_sound_speed = 5328.0, hugoniot_slope = 1.338, grueneisen = 2.0 }\n"
          "strength = { model = 'perfectly-plastic', shear_modulus = '27.6 GPa', yield_stress = '0.3 GPa' }\n"
          "[time]\nend = '0.25 us'\n",
      std::move(particles));
  const int along = rings ? 1 : 0;
  const auto before = run.ledger();
  test::run_to_the_end(run);
  const auto after = run.ledger();
  return {after.total() / before.total() - 1.0, after.momentum[along] / before.momentum[along] - 1.0};
}

}  // namespace

TEST_CASE("Spacings by msph: adjoint forces keep momentum and energy, whatever the ratio", "[msph]") {
  for (const auto space : {Space::line, Space::plane_strain, Space::axisymmetric})
    for (const double ratio : {1.0, 2.0, 4.0}) {
      INFO(name_of(space) << ", spacings of 1 to " << ratio);
      const auto drift = after_impact(space, "forces = 'adjoint'", ratio);
      CHECK(std::abs(drift.momentum) < 1e-13);
      CHECK(std::abs(drift.energy) < 0.03);  // equal: 0.01, and the coarser bodies; 0.6 to 8 by each particle's own h
    }
}

TEST_CASE("Spacings by msph: strong forces lose no more than they do with equal ones", "[msph]") {
  for (const auto space : {Space::line, Space::plane_strain, Space::axisymmetric}) {
    INFO(name_of(space));
    const auto drift = after_impact(space, "forces = 'strong'", 2.0);
    CHECK(std::abs(drift.momentum) < 0.1);  // 0.03 to 0.06; up to 0.5 by the h of each particle
    CHECK(std::abs(drift.energy) < 0.1);    // 0.001 to 0.08; up to 1.8
  }
}
