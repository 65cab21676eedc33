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

/// One step of a linear motion from rest by this scheme, with and without particles on the axis: the density follows it
/// everywhere, and radial and hoop stress are the same.
void check_linear_motion(const std::string& scheme, double of_density, double of_stress) {
  for (const double offset : {0.0, 0.5}) {
    auto p = rod(offset);
    constexpr double across = 20.0, along = -35.0;  // 1/s
    for (std::size_t i = 0; i < p.count(); ++i) {
      p.reals(Field::velocity)[2 * i] = across * p.reals(Field::position)[2 * i];
      p.reals(Field::velocity)[2 * i + 1] = along * p.reals(Field::position)[2 * i + 1];
    }
    auto simulation = test::simulation_of("time.end = '1 s'\n" + scheme + steel, std::move(p));
    simulation.step();
    const auto rho = test::by_id(simulation.particles(), Field::density);
    const auto s = test::by_id(simulation.particles(), Field::deviatoric_stress);
    const double dt = simulation.time();
    const double expected = density / (std::pow(1.0 + across * dt, 2) * (1.0 + along * dt));
    for (std::size_t i = 0; i < rho.size(); ++i) {
      CHECK(rho[i] == Approx(expected).epsilon(of_density));
      CHECK(s[4 * i] == Approx(s[0]).epsilon(of_stress));
      CHECK(s[4 * i + 2] == Approx(s[4 * i]).epsilon(of_stress));  // hoop and radial stress are the same
    }
  }
}

}  // namespace

TEST_CASE("Axis: a linear motion is uniform up to the axis and the mantle", "[msph][axis]") {
  // The midpoint rule is exact to (D dt)³, below 1e-15; B's condition leaves round-off of 1e-13 of 1/ρ dρ.
  check_linear_motion("scheme = { type = 'msph', smoothing_share = 0.0 }\n", 1e-13, 1e-8);
}

TEST_CASE("Axis: rings of the total-Lagrangian scheme follow a linear motion exactly, on the axis and on the mantle",
          "[total-lagrangian][axis]") {
  // exp(-tr D dt/2) of the second half of a step is exact to (D dt)², 1e-12.
  check_linear_motion("scheme.type = 'total-lagrangian'\nviscosity = { alpha = 0.0, beta = 0.0 }\n", 1e-11, 1e-6);
}

TEST_CASE("Axis: a bar that vibrates keeps its energy and its momentum along the axis", "[axis]") {
  struct Case {
    std::string scheme;
    int steps;        ///< to another phase of the vibration
    double of_total;  ///< what the energy may drift by
  };
  // The leapfrog's own drift is of second order in the step, 1.3e-4 with a courant number of 0.25. MSPH's velocities
  // are those of the middle of steps, so that its sum is off by half a step of the vibration, 7e-3 of a radian.
  for (const Case& c : {Case{"type = 'total-lagrangian'", 700, 1e-4}, Case{"type = 'eulerian'", 700, 1e-4},
                        Case{"type = 'msph', forces = 'adjoint', smoothing_share = 0.0", 550, 1e-2}}) {
    for (const double offset : {0.0, 0.5}) {
      INFO(c.scheme << ", first particle at " << offset << " spacings");
      auto p = rod(offset);
      for (std::size_t i = 0; i < p.count(); ++i)
        p.reals(Field::velocity)[2 * i + 1] = 5.0 + 20.0 * std::cos(M_PI * p.reals(Field::position)[2 * i + 1] / 0.029);
      auto simulation =
          test::simulation_of("time.end = '1 s'\nscheme = { courant = 0.1, " + c.scheme + " }\n" + steel, std::move(p));
      const auto before = simulation.ledger();
      test::take_steps(simulation, c.steps);
      const auto after = simulation.ledger();
      CHECK(after.momentum[1] == Approx(before.momentum[1]).epsilon(1e-12));
      CHECK(after.total() == Approx(before.total()).epsilon(c.of_total));
      CHECK(after.kinetic < 0.9 * before.kinetic);  // it did vibrate
    }
  }
}

TEST_CASE("Axis: a bar under uniform pressure at rest does not feel the axis", "[axis]") {
  // A compressed fluid on a symmetry plane: only its mantle and its top are free, and in the first step the middle, far
  // from both, has nothing to do.
  const std::string fluid =
      "smoothing = { kernel = 'truncated-gaussian', ratio = 1.5 }\n"
      "symmetry.below = { axis = 'y', at = -0.0005 }\n"
      "[material.steel]\ndensity = 7746.0\neos = { model = 'linear', bulk_modulus = '169.1 GPa' }\n";
  for (const std::string scheme : {"total-lagrangian", "eulerian"}) {
    auto p = rod(0.5);
    auto simulation = test::simulation_of("time.end = '1 s'\nscheme.type = '" + scheme + "'\n" + fluid, std::move(p));
    simulation.step();
    const auto a = test::by_id(simulation.particles(), Field::acceleration);
    const auto pressure = test::by_id(simulation.particles(), Field::pressure)[0];
    REQUIRE(pressure > 1.8e9);
    double inner = 0.0;
    for (std::size_t row = 0; row < 20; ++row)
      for (std::size_t k = 0; k < 5; ++k) inner = std::max(inner, std::abs(a[20 * row + 2 * k]));
    // What the sum over a lattice leaves of an integral over the kernel, in p/(ρ δ): a ring without its image has 1.
    WARN(scheme << ": " << inner / (pressure / (density * spacing)));
    CHECK(inner < 0.1 * pressure / (density * spacing));
  }
}

TEST_CASE("Axis: an elastic rod leaves a rigid anvil again with all its energy", "[axis][anvil]") {
  for (const std::string scheme : {"total-lagrangian", "eulerian"}) {
    INFO(scheme);
    auto p = rod(0.5);
    for (std::size_t i = 0; i < p.count(); ++i) p.reals(Field::velocity)[2 * i + 1] = -20.0;
    auto simulation = test::simulation_of(
        "time.end = '30 us'\nanvil.axis = 'y'\nscheme.type = '" + scheme + "'\n" + steel, std::move(p));
    const auto before = simulation.ledger();
    test::run_to_the_end(simulation);
    const auto after = simulation.ledger();
    // What stopping takes of the kinetic energy, a thirtieth here, is heat; the leapfrog drifts by less than a tenth of
    // it.
    CHECK(after.total() == Approx(before.total()).epsilon(3e-3));
    CHECK(after.momentum[1] > 0.5 * std::abs(before.momentum[1]));
    const auto x = test::by_id(simulation.particles(), Field::position);
    for (std::size_t i = 0; i < x.size(); i += 2) CHECK(x[i + 1] > 0.0);
  }
}

TEST_CASE("Axis: a spherical shell that implodes keeps its energy, sane to the end", "[axis]") {
  // Particles that are driven to a small part of a spacing from the axis: as sections of volume over circumference they
  // had no bound, and the run ended when the shell closed.
  auto p = test::particles_on(
      Space::axisymmetric,
      {{"shell",
        "steel",
        spacing,
        {0.5 * spacing, -19.5 * spacing},
        {20, 40},
        {0.0, 0.0},
        [](const double* x) { return std::abs(std::hypot(x[0], x[1]) - 16.0 * spacing) < 4.0 * spacing; },
        1.4}},
      density);
  for (std::size_t i = 0; i < p.count(); ++i) {
    const double* x = &p.reals(Field::position)[2 * i];
    p.scalars(Field::mass)[i] *= 2.0 * M_PI * x[0];
    for (std::size_t k = 0; k < 2; ++k) p.reals(Field::velocity)[2 * i + k] = -1500.0 * x[k] / std::hypot(x[0], x[1]);
  }
  auto simulation = test::simulation_of(
      "time.end = '16 us'\nscheme.type = 'eulerian'\n[material.steel]\ndensity = 7830.0\n"
      "eos = { model = 'mie-grueneisen', bulk_sound_speed = '4570 m/s', hugoniot_slope = 1.49, grueneisen = 1.9 }\n"
      "strength = { model = 'perfectly-plastic', shear_modulus = '80 GPa', yield_stress = '0.5 GPa' }\n",
      std::move(p));
  const auto before = simulation.ledger();
  double least = 1.0;  // distance from the axis that any particle comes to
  while (!simulation.finished()) {
    simulation.step();
    for (std::size_t i = 0; i < simulation.particles().count(); ++i)
      least = std::min(least, simulation.particles().reals(Field::position)[2 * i]);
  }
  const auto after = simulation.ledger();
  CHECK(least > 0.0);
  CHECK(least < 0.3 * spacing);
  CHECK(after.total() == Approx(before.total()).epsilon(2e-3));  // the leapfrog's drift through the collapse
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
