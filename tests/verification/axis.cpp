// The axis of an axisymmetric space: what does not know of it does not see it, and the steady axis of a bar stays
// sound.
#include <catch2/catch.hpp>

#include "support/lattice.hpp"

using namespace tektite;

namespace {

constexpr double spacing = 1e-3, density = 7830.0;
const std::string steel =
    "smoothing = { kernel = 'truncated-gaussian', ratio = 1.5 }\n"
    "[material.steel]\ndensity = 7830.0\neos = { model = 'linear', bulk_modulus = '169.1 GPa' }\n"
    "strength = { model = 'elastic', shear_modulus = '82.9 GPa' }\n";

/// A rod from the axis to its mantle, particles on both, with ring masses.
Particles rod(double offset) {
  auto p = test::particles_on(Space::axisymmetric,
                              {{"rod", "steel", spacing, {offset * spacing, 0.0}, {10, 30}, {0.0, 0.0}, nullptr, 1.5}},
                              density);
  for (std::size_t i = 0; i < p.count(); ++i)
    p.scalars(Field::mass)[i] *= 2.0 * M_PI * std::max(p.reals(Field::position)[2 * i], 0.125 * spacing);
  return p;
}

}  // namespace

TEST_CASE("Axis: a linear motion is uniform up to the axis and the mantle", "[msph][axis]") {
  for (const double offset : {0.0, 0.5}) {
    auto p = rod(offset);
    constexpr double across = 20.0, along = -35.0;  // 1/s
    for (std::size_t i = 0; i < p.count(); ++i) {
      p.reals(Field::velocity)[2 * i] = across * p.reals(Field::position)[2 * i];
      p.reals(Field::velocity)[2 * i + 1] = along * p.reals(Field::position)[2 * i + 1];
    }
    auto simulation = test::simulation_of(
        "time.end = '1 s'\nscheme = { type = 'msph', smoothing_share = 0.0 }\n" + steel, std::move(p));
    simulation.step();
    const auto rho = test::by_id(simulation.particles(), Field::density);
    const auto s = test::by_id(simulation.particles(), Field::deviatoric_stress);
    const double dt = simulation.time();
    const double expected = density / (std::pow(1.0 + across * dt, 2) * (1.0 + along * dt));
    for (std::size_t i = 0; i < rho.size(); ++i) {
      // The midpoint rule is exact to (D dt)³, below 1e-15; B's condition leaves round-off of 1e-13 of 1/ρ dρ.
      CHECK(rho[i] == Approx(expected).epsilon(1e-13));
      CHECK(s[4 * i] == Approx(s[0]).epsilon(1e-8));
      CHECK(s[4 * i + 2] == Approx(s[4 * i]).epsilon(1e-8));  // hoop and radial stress are the same
    }
  }
}

TEST_CASE("Axis: a stretched rod vibrates as one, with no mark of the axis", "[msph][axis]") {
  auto p = rod(0.0);
  for (std::size_t i = 0; i < p.count(); ++i)
    p.reals(Field::velocity)[2 * i + 1] =
        -2.0 * std::sin(M_PI * p.reals(Field::position)[2 * i + 1] / (29.0 * spacing) - M_PI / 2.0);
  auto simulation = test::simulation_of("time.end = '1 s'\nscheme.type = 'msph'\n" + steel, std::move(p));
  test::take_steps(simulation, 200);
  const auto x = test::by_id(simulation.particles(), Field::position);
  const auto pressure = test::by_id(simulation.particles(), Field::pressure);
  double largest = 0.0, jump = 0.0;
  for (std::size_t row = 0; row < 30; ++row) {
    for (std::size_t k = 0; k < 10; ++k) largest = std::max(largest, std::abs(pressure[10 * row + k]));
    // An even field: what the axis has beyond its neighbours' parabola.
    const double* r = &pressure[10 * row];
    jump = std::max(jump, std::abs(r[0] - (4.0 * r[1] - r[2]) / 3.0));
    CHECK(x[20 * row] == 0.0);
  }
  WARN("pressure up to " << largest << " Pa; the axis stands off its neighbours by " << jump << " Pa");
  CHECK(jump < 0.02 * largest);
}
