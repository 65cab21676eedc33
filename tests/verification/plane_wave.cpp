// A plane longitudinal wave through a plate and a block, read near their middle before anything comes in from the free
// sides: √((K + 4G/3)/ρ) in plane strain and in a solid, √(E/(ρ (1 - ν²))) in plane stress.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <numbers>

#include "support/lattice_sums.hpp"

using namespace tektite;

namespace {

constexpr double density = 2785.0, bulk = 79e9, shear = 27.6e9;
constexpr double young = 9.0 * bulk * shear / (3.0 * bulk + shear), poisson = young / (2.0 * shear) - 1.0;
constexpr double spacing = 1e-3, amplitude = 0.1;  // m, m/s

/// Lengths in spacings.
struct Size {
  int wave, travel, length, half_width;
};

double wave_speed(Space space) {
  if (space == Space::plane_stress) return std::sqrt(young / (density * (1.0 - poisson * poisson)));
  return std::sqrt((bulk + 4.0 / 3.0 * shear) / density);
}

/// A block above y = 0 (and z = 0), which are symmetry planes, with a pulse v = A cos⁴ that starts near its left end.
template <Space space>
Particles block_with_wave(const Size& size) {
  constexpr int D = dimensions_of(space);
  test::Lattice lattice{"block", "metal", spacing, {}, {}, std::vector<double>(D, 0.0)};
  lattice.first.assign(D, 0.5 * spacing);
  lattice.count.assign(D, size.half_width);
  lattice.count[0] = size.length;
  auto p = test::particles_on(space, {lattice}, density);
  p.allocate(Field::deviatoric_stress);
  const double c = wave_speed(space), wave = size.wave * spacing, start = 0.75 * wave;
  for (std::size_t i = 0; i < p.count(); ++i) {
    const double x = p.vectors<D>(Field::position)[i][0] - start;
    if (std::abs(x) > 0.5 * wave) continue;
    const double v = amplitude * std::pow(std::cos(std::numbers::pi * x / wave), 4);
    auto strain = Symmetric<double, D>::zero();
    strain.c[0] = -v / c;
    if (space == Space::plane_stress) strain.c[2] = poisson / (1.0 - poisson) * v / c;
    p.vectors<D>(Field::velocity)[i][0] = v;
    p.scalars(Field::density)[i] = density * std::exp(-trace(strain));
    p.symmetrics<D>(Field::deviatoric_stress)[i] = (2.0 * shear) * deviator(strain);
  }
  return p;
}

/// The place of the pulse's centre along the symmetry axis, from the particles next to it, in m.
template <Space space>
double centre_on_axis(const Particles& p) {
  constexpr int D = dimensions_of(space);
  double momentum = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < p.count(); ++i) {
    const auto& x = p.vectors<D>(Field::position)[i];
    bool near = true;
    for (int k = 1; k < D; ++k) near = near && x[k] < spacing;
    if (!near) continue;
    momentum += p.vectors<D>(Field::velocity)[i][0];
    moment += p.vectors<D>(Field::velocity)[i][0] * x[0];
  }
  return moment / momentum;
}

/// The speed of the wave over the exact one.
template <Space space>
double relative_speed(const Size& size,
                      const std::string& scheme = "viscosity = { model = 'monaghan', alpha = 0.0, beta = 0.0 }\n") {
  constexpr int D = dimensions_of(space);
  const double c = wave_speed(space), travel = size.travel * spacing;
  std::string scene = fmt::format(
      "time.end = {}\n{}symmetry.bottom = {{ axis = 'y' }}\n"
      "[material.metal]\ndensity = {}\neos = {{ model = 'linear', bulk_modulus = {} }}\n"
      "strength = {{ model = 'elastic', shear_modulus = {} }}\n",
      travel / c, scheme, density, bulk, shear);
  if (D == 3) scene = "symmetry.back = { axis = 'z' }\n" + scene;
  auto simulation = test::simulation_of(scene, block_with_wave<space>(size));
  const double before = centre_on_axis<space>(simulation.particles());
  test::run_to_the_end(simulation);
  return (centre_on_axis<space>(simulation.particles()) - before) / travel;
}

}  // namespace

TEST_CASE("Plane wave: in plane strain it runs with the longitudinal speed", "[wave]") {
  const double ratio = relative_speed<Space::plane_strain>({40, 40, 120, 46});
  const double expected = test::lattice_slope<CubicSpline, 2>();
  WARN("plane strain: speed/exact " << ratio << ", on a lattice " << expected);
  CHECK(ratio == Approx(expected).epsilon(5e-3));
  CHECK(ratio == Approx(1.0).epsilon(0.02));
}

TEST_CASE("Plane wave: in plane stress it runs with the plate's speed", "[wave]") {
  const double ratio = relative_speed<Space::plane_stress>({40, 40, 120, 46});
  const double expected = test::lattice_slope<CubicSpline, 2>();
  WARN("plane stress: speed/exact " << ratio << ", on a lattice " << expected << "; the plate's speed is "
                                    << wave_speed(Space::plane_stress) / wave_speed(Space::plane_strain)
                                    << " of the longitudinal one");
  CHECK(ratio == Approx(expected).epsilon(5e-3));
  CHECK(ratio == Approx(1.0).epsilon(0.02));
}

TEST_CASE("Plane wave: in plane stress it does so with the Godunov schemes, which damp it", "[wave]") {
  for (const std::string scheme : {"type = 'godunov-pm'", "type = 'godunov-split'"}) {
    const double ratio = relative_speed<Space::plane_stress>({40, 40, 120, 46}, "scheme = { " + scheme + " }\n");
    WARN(scheme << ": speed/exact " << ratio);
    CHECK(ratio == Approx(1.0).epsilon(0.02));
  }
}

TEST_CASE("Plane wave: in a solid it runs with the longitudinal speed", "[wave]") {
  const double ratio = relative_speed<Space::solid>({20, 12, 50, 18});
  const double expected = test::lattice_slope<CubicSpline, 3>();
  WARN("solid: speed/exact " << ratio << ", on a lattice " << expected);
  CHECK(ratio == Approx(expected).epsilon(0.02));
  CHECK(ratio == Approx(1.0).epsilon(0.04));
}
