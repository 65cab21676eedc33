// Order in time of the split Godunov scheme: a smooth elastic wave on the same particles, with time steps that are
// halved.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <numbers>

#include "support/lattice.hpp"

using namespace tektite;

namespace {

constexpr double density = 2785.0, bulk = 79e9, shear = 27.6e9;
const double speed = std::sqrt((bulk + 4.0 / 3.0 * shear) / density);  // 6447 m/s
constexpr double spacing = 1e-3, amplitude = 0.1;                      // m, m/s: strains of 2e-5
constexpr int count = 120, pulse = 40;                                 // particles
constexpr double ratio = 2.0, courant = 0.4;                           // the largest step
constexpr int steps = 20;  // of the largest step: the waves travel 16 spacings, and reach no surface

/// Velocities at the end, with steps of courant/parts.
std::vector<double> velocities(const std::string& splitting, int parts) {
  auto bar = test::particles_on(Space::line,
                                {{"bar", "metal", spacing, {0.5 * spacing}, {count}, {0.0}, nullptr, ratio}}, density);
  for (std::size_t i = 0; i < bar.count(); ++i) {
    const double x = (static_cast<double>(i) + 0.5 - 0.5 * count) / pulse;
    if (std::abs(x) < 0.5) bar.scalars(Field::velocity)[i] = amplitude * std::pow(std::cos(std::numbers::pi * x), 4);
  }
  auto simulation = test::simulation_of(
      fmt::format("time.end = {}\n"
                  "scheme = {{ type = 'godunov-split', courant = {}, splitting = '{}', limiter.model = 'van-leer' }}\n"
                  "[material.metal]\ndensity = {}\neos = {{ model = 'linear', bulk_modulus = {} }}\n"
                  "strength = {{ model = 'elastic', shear_modulus = {} }}\n",
                  steps * courant * ratio * spacing / speed, courant / parts, splitting, density, bulk, shear),
      std::move(bar));
  test::run_to_the_end(simulation);
  return test::by_id(simulation.particles(), Field::velocity);
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

/// The order by which the velocities of three runs, each with half the step of the one before, come together.
double order_in_time(const std::string& splitting) {
  const auto coarse = velocities(splitting, 1), middle = velocities(splitting, 2), fine = velocities(splitting, 4);
  const double first = distance(coarse, middle), last = distance(middle, fine), order = std::log2(first / last);
  WARN(fmt::format("{}: differences {:.3g} {:.3g} m/s, order {:.2f}", splitting, first, last, order));
  CHECK(last > 1e-8 * amplitude);  // far above round-off
  return order;
}

}  // namespace

TEST_CASE("Splitting: Strang's is of second order in time, that of Lie and Trotter of first", "[godunov]") {
  const double strang = order_in_time("strang"), lie = order_in_time("lie-trotter");
  // Two orders of an asymptotic law, told apart in its middle.
  CHECK(strang == Approx(2.0).margin(0.25));
  CHECK(lie == Approx(1.0).margin(0.25));
}
