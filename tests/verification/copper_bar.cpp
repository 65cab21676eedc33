// A bar of soft copper on a smooth anvil, beside a solution of the same material by finite elements: quadrilaterals of
// 0.24 mm about the axis, deviator at 2 x 2 points, one mean volume change, radial return.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "support/lattice.hpp"

using namespace tektite;

namespace {

constexpr double density = 8960.0, radius = 3.8e-3, length = 25.4e-3;  // kg/m³, m
constexpr double exact_length = 17.35e-3, exact_face = 14.64e-3;       // m

struct Bar {
  double length, face;  ///< m
  double to_viscosity;  ///< of the energy
};

Bar strike(const std::string& viscosity) {
  constexpr int across = 11, along = 68;
  constexpr double spacing = radius / (across - 1);
  auto p = test::particles_on(Space::axisymmetric,
                              {{"bar", "copper", spacing, {0.0, 0.0}, {across, along}, {0.0, -190.0}}}, density);
  for (std::size_t i = 0; i < p.count(); ++i)
    p.scalars(Field::mass)[i] *= 2.0 * M_PI * std::max(p.reals(Field::position)[2 * i], 0.125 * spacing);
  auto run = test::simulation_of(
      "scheme.type = 'total-lagrangian'\nanvil.axis = 'y'\ntime.end = '75 us'\nviscosity." + viscosity +
          "\n[material.copper]\ndensity = 8960.0\neos = { model = 'linear', bulk_modulus = '129 GPa' }\n"
          "strength = { model = 'johnson-cook', shear_modulus = '46 GPa', a = '90 MPa', b = '292 MPa', n = 0.31, "
          "c = 0.025, m = 1.09, melting_temperature = '1356 K', specific_heat = '383 J/(kg K)' }\n",
      std::move(p));
  const double before = run.ledger().total();
  test::run_to_the_end(run);
  const auto x = test::by_id(run.particles(), Field::position);
  return {(x[2 * across * (along - 1) + 1] - x[1]) * length / ((along - 1) * spacing), 2.0 * x[2 * (across - 1)],
          run.ledger().viscous / before};
}

}  // namespace

TEST_CASE("Copper bar: without linear viscosity the length is that of finite elements, and with it the bar is too long",
          "[total-lagrangian][taylor]") {
  const auto without = strike("alpha = 0.0"), with = strike("alpha = 1.0");
  WARN("length " << without.length << " and " << with.length << " m, face " << without.face << " and " << with.face
                 << " m, to viscosity " << without.to_viscosity << " and " << with.to_viscosity);
  CHECK(without.length == Approx(exact_length).epsilon(0.005));
  CHECK(without.face == Approx(exact_face).epsilon(0.05));  // the face's particle is a spacing wide, 2.6 %
  CHECK(without.to_viscosity < 0.02);
  CHECK(with.length > 1.04 * exact_length);
  CHECK(with.to_viscosity > 0.15);
}

TEST_CASE("Copper bar: the limited viscosity leaves the length that of finite elements", "[total-lagrangian][taylor]") {
  const auto bar = strike("model = 'limited'");
  WARN("length " << bar.length << " m, face " << bar.face << " m, to viscosity " << bar.to_viscosity);
  CHECK(bar.length == Approx(exact_length).epsilon(0.01));
  CHECK(bar.to_viscosity < 0.05);  // 20 % by the other one
}
