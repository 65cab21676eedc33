// A disc of steel strikes a plate of aluminium obliquely at 2.8 km/s and breaks through: nothing is a lattice any more,
// fragments of a few particles fly apart, and the materials differ. Each scheme with its defaults.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "support/lattice.hpp"

using namespace tektite;

namespace {

constexpr double spacing = 5e-4;  // m
constexpr double steel = 7850.0, aluminium = 2785.0;

Particles disc_and_plate() {
  const test::Lattice disc{
      "disc", "steel", spacing, {-10.25e-3, 0.75e-3}, {20, 20}, {2000.0, -2000.0}, [](const double* x) {
        return std::hypot(x[0] + 5.5e-3, x[1] - 5.5e-3) <= 5e-3;
      }};
  const test::Lattice plate{"plate", "aluminium", spacing, {0.25e-3, -29.75e-3}, {8, 100}, {0.0, 0.0}};
  auto particles = test::particles_on(Space::plane_strain, {disc, plate}, steel);
  const auto& range = particles.bodies()[1].range;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    particles.scalars(Field::mass)[i] *= aluminium / steel;
    particles.scalars(Field::density)[i] = aluminium;
  }
  return particles;
}

}  // namespace

TEST_CASE("Oblique impact: steel goes through aluminium, and momentum and energy stay", "[impact]") {
  struct Case {
    std::string scheme, more;
    double drift, momentum;
  };
  // What two kinds of kernels do to each other is not conserved to round-off.
  const auto& [scheme, more, drift, momentum] =
      GENERATE(Case{"type = 'eulerian'", "", 1e-3, 1e-12}, Case{"type = 'godunov-split', order = 2", "", 1e-12, 1e-12},
               Case{"type = 'godunov-pm'", "", 1e-12, 1e-12},
               // The fragments are too few for the correction, and none of them is torn by it.
               Case{"type = 'eulerian', correction = 'mixed'", "", 1e-3, 1e-12},
               Case{"type = 'godunov-split', correction = 'mixed'", "", 1e-12, 1e-12},
               Case{"type = 'adaptle', conversion = 'strain', conversion_strain = 0.5, correction = 'mixed'",
                    "contact.model = 'kernel-penalty'\n", 0.03, 0.02},
               Case{"type = 'adaptle', conversion = 'strain', conversion_strain = 0.5",
                    "contact.model = 'kernel-penalty'\n", 0.02, 0.02});
  INFO(scheme);
  auto run = test::simulation_of(
      "scheme = { " + scheme + " }\ntime.end = '15 us'\n" + more +
          "[material.steel]\ndensity = 7850.0\n"
          "eos = { model = 'mie-grueneisen', bulk_sound_speed = 4570.0, hugoniot_slope = 1.49, grueneisen = 2.0 }\n"
          "strength = { model = 'perfectly-plastic', shear_modulus = '80 GPa', yield_stress = '0.8 GPa' }\n"
          "[material.aluminium]\ndensity = 2785.0\n"
          "eos = { model = 'mie-grueneisen', bulk_sound_speed = 5328.0, hugoniot_slope = 1.338, grueneisen = 2.0 }\n"
          "strength = { model = 'perfectly-plastic', shear_modulus = '27.6 GPa', yield_stress = '0.3 GPa' }\n",
      disc_and_plate());
  const auto before = run.ledger();
  while (!run.finished()) REQUIRE_NOTHROW(run.step());
  const auto after = run.ledger();
  CHECK(std::abs(after.total() / before.total() - 1.0) < drift);
  const double whole = std::hypot(before.momentum[0], before.momentum[1]);
  CHECK(std::hypot(after.momentum[0] - before.momentum[0], after.momentum[1] - before.momentum[1]) < momentum * whole);
  const auto& disc = run.particles().bodies()[0].range;
  std::size_t through = 0;
  for (std::size_t i = disc.begin; i < disc.end; ++i) through += run.particles().reals(Field::position)[2 * i] > 4e-3;
  CHECK(2 * through > disc.size());
}
