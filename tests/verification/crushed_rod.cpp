// A rod of soft copper that flattens on an anvil far beyond what gradients of the reference configuration are good for:
// where particles have come nearer by a tenth, so have the time steps that they stand.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "support/lattice.hpp"

using namespace tektite;

TEST_CASE("Total Lagrangian: a rod is crushed to a plastic strain beyond 1.5 without losing its energy",
          "[lagrangian][taylor]") {
  constexpr int across = 9, along = 82;
  constexpr double spacing = 3.2e-3 / (across - 1);
  auto p = test::particles_on(Space::axisymmetric,
                              {{"rod", "copper", spacing, {0.0, 0.0}, {across, along}, {0.0, -227.0}, nullptr, 1.4}},
                              8930.0);
  for (std::size_t i = 0; i < p.count(); ++i)
    p.scalars(Field::mass)[i] *= 2.0 * M_PI * std::max(p.reals(Field::position)[2 * i], 0.125 * spacing);
  auto simulation = test::simulation_of(
      "scheme = { type = 'total-lagrangian' }\nanvil.axis = 'y'\ntime.end = '40 us'\n"
      "[material.copper]\ndensity = 8930.0\neos = { model = 'linear', bulk_modulus = '130 GPa' }\n"
      "strength = { model = 'isotropic-hardening', shear_modulus = '43.333 GPa', yield_stress = '400 MPa', "
      "plastic_modulus = '100 MPa' }\n",
      std::move(p));
  const double before = simulation.ledger().total();
  while (!simulation.finished()) REQUIRE_NOTHROW(simulation.step());
  const auto strain = simulation.particles().reals(Field::plastic_strain);
  CHECK(*std::max_element(strain.begin(), strain.end()) > 1.5);
  CHECK(std::abs(simulation.ledger().total() / before - 1.0) < 1e-3);
}
