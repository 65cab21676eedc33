// A longitudinal wave in a bar under uniaxial strain: u(x, t) = f(x - c_l t), c_l² = (K + 4G/3)/ρ.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <numbers>

#include "support/convergence.hpp"
#include "support/lattice_sums.hpp"

using namespace tektite;

namespace {

constexpr double density = 2785.0, bulk = 79e9, shear = 27.6e9;
const double speed = std::sqrt((bulk + 4.0 / 3.0 * shear) / density);  // 6447 m/s
constexpr double bar = 0.4, width = 0.1;                               // m
constexpr double centre = 0.12, travel = 0.16;                         // m
constexpr double amplitude = 0.1;  // m/s: strains of 2e-5, so that the wave is linear to as much

/// sin⁴ over `width` about zero, with three continuous derivatives.
double pulse(double x) { return std::abs(x) < 0.5 * width ? std::pow(std::cos(std::numbers::pi * x / width), 4) : 0.0; }

/// Its integral from -∞.
double pulse_integral(double x) {
  const double s = std::clamp(x, -0.5 * width, 0.5 * width), k = 2.0 * std::numbers::pi / width;
  const double half = 0.5 * width;
  const auto primitive = [&](double y) {
    return 0.375 * y + std::sin(k * y) / (2.0 * k) + std::sin(2.0 * k * y) / (16.0 * k);
  };
  return primitive(s) - primitive(-half);
}

/// A bar that carries the wave v = A f(x - centre): strain -v/c_l, and the stress that belongs to it.
Particles travelling_wave(double spacing, double ratio) {
  const int count = static_cast<int>(std::lround(bar / spacing));
  auto p = test::particles_on(Space::line, {{"bar", "metal", spacing, {0.5 * spacing}, {count}, {0.0}, nullptr, ratio}},
                              density);
  p.allocate(Field::deviatoric_stress);
  for (std::size_t i = 0; i < p.count(); ++i) {
    auto& x = p.scalars(Field::position)[i];
    const double v = amplitude * pulse(x - centre), strain = -v / speed;
    p.scalars(Field::velocity)[i] = v;
    p.scalars(Field::density)[i] = density * std::exp(-strain);
    p.symmetrics<1>(Field::deviatoric_stress)[i] =
        (2.0 * shear * strain) * Symmetric<double, 1>{{2.0 / 3.0, -1.0 / 3.0, -1.0 / 3.0}};
    x -= amplitude / speed * pulse_integral(x - centre);
  }
  return p;
}

struct Result {
  double error;      ///< L1 error of the velocity over the L1 norm of the wave
  double speed;      ///< of the pulse's centre, over c_l
  double amplitude;  ///< largest velocity over the exact one
  double drift;      ///< of the energy of the wave
};

Result carry_wave(double spacing, double ratio) {
  auto simulation = test::simulation_of(
      fmt::format("time.end = {}\nviscosity = {{ model = 'monaghan', alpha = 0.0, beta = 0.0 }}\n"
                  "[material.metal]\ndensity = {}\neos = {{ model = 'linear', bulk_modulus = {} }}\n"
                  "strength = {{ model = 'elastic', shear_modulus = {} }}\n",
                  travel / speed, density, bulk, shear),
      travelling_wave(spacing, ratio));
  const double kinetic = simulation.ledger().kinetic;
  const double before = simulation.ledger().total();
  test::run_to_the_end(simulation);
  const double after = simulation.ledger().total();

  const auto& p = simulation.particles();
  double error = 0.0, norm = 0.0, momentum = 0.0, moment = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < p.count(); ++i) {
    const double x = p.scalars(Field::position)[i], v = p.scalars(Field::velocity)[i];
    const double exact = amplitude * pulse(x - centre - travel);
    error += std::abs(v - exact);
    norm += exact;
    momentum += v;
    moment += v * x;
    largest = std::max(largest, v);
  }
  return {error / norm, (moment / momentum - centre) / travel, largest / amplitude, (after - before) / kinetic};
}

}  // namespace

TEST_CASE("Elastic wave in a bar: with a smoothing length of two spacings the error falls with their square",
          "[wave]") {
  // There the cubic spline gives a field of slope one its slope exactly, so that nothing but the spacing is in the way.
  CHECK(test::lattice_slope<CubicSpline, 1>(2.0) == Approx(1.0).epsilon(1e-14));
  const auto coarse = carry_wave(0.004, 2.0), middle = carry_wave(0.002, 2.0), fine = carry_wave(0.001, 2.0);
  const auto order = test::convergence("velocity", {coarse.error, middle.error, fine.error});
  WARN("speed/exact " << coarse.speed << " " << middle.speed << " " << fine.speed << "; amplitude " << coarse.amplitude
                      << " " << middle.amplitude << " " << fine.amplitude << "; drift " << fine.drift);
  CHECK(order > 1.8);
  CHECK(fine.error < 0.05);  // the pulse is a hundred spacings long, and h is two
  CHECK(fine.speed == Approx(1.0).epsilon(1e-3));
  CHECK(fine.amplitude == Approx(1.0).epsilon(0.005));
  CHECK(std::abs(fine.drift) < 1e-3);
}

TEST_CASE("Elastic wave in a bar: with other smoothing lengths the speed is that of the lattice", "[wave]") {
  for (const double ratio : {1.2, 1.4, 1.6}) {
    const auto wave = carry_wave(0.001, ratio);
    const double expected = test::lattice_slope<CubicSpline, 1>(ratio);
    WARN("h/δ " << ratio << ": speed/exact " << wave.speed << ", on a lattice " << expected << "; amplitude "
                << wave.amplitude);
    CHECK(wave.speed == Approx(expected).epsilon(1e-3));  // the pulse is a hundred spacings long
    CHECK(wave.amplitude == Approx(1.0).epsilon(0.005));
  }
}
