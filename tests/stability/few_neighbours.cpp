// Corrections and expansions that a particle has too few neighbours for, or neighbours in too little order.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "support/lattice.hpp"
#include "support/lattice_sums.hpp"
#include "support/said.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

constexpr double spacing = 1e-3, density = 2785.0;
const std::string metal =
    "[material.metal]\ndensity = 2785.0\neos = { model = 'linear', bulk_modulus = 79e9 }\n"
    "strength = { model = 'elastic', shear_modulus = 27.6e9 }\n";

struct Strained {
  double seen;  ///< of the rate of deformation along a strip, in its middle
  std::set<std::string> names;
};

/// A strip of so many rows that is drawn out along itself.
Strained drawn_strip(const std::string& scheme, int rows) {
  constexpr int length = 31;
  constexpr double rate = 1e3;
  auto particles =
      particles_on(Space::plane_strain, {{"strip", "metal", spacing, {0.0, 0.0}, {length, rows}, {0.0, 0.0}}}, density);
  for (std::size_t i = 0; i < particles.count(); ++i)
    particles.reals(Field::velocity)[2 * i] = rate * particles.reals(Field::position)[2 * i];
  particles.allocate(Field::velocity_gradient);  // which a scheme may do without
  auto simulation = simulation_of("time.end = 1.0\n" + scheme + metal, std::move(particles));
  simulation.step();
  const auto l = by_id(simulation.particles(), Field::velocity_gradient);
  const std::size_t middle = static_cast<std::size_t>((rows / 2) * length + length / 2);
  return {l[4 * middle] / rate, said(simulation)};
}

/// What the plain sum over a single row gives to a slope of one.
double slope_of_a_row(double ratio) {
  double slope = 0.0;
  for (int n = 1; n < 2.0 * ratio; ++n) slope -= 2.0 * n * kernel_slope<CubicSpline, 2>(n, ratio);
  return slope;
}

struct Lower {
  double first = 0.0, zeroth = 0.0;  ///< of particle steps
  double error = 0.0;                ///< of the velocity gradient, largest, over it
  std::set<std::string> names;
};

/// One step of a square, its particles off their places by `disorder` of the spacing, that is drawn out evenly.
Lower disordered(double ratio, double disorder) {
  constexpr int side = 24;
  constexpr double rate = 1e3;
  auto particles =
      particles_on(Space::plane_strain,
                   {{"square", "metal", spacing, {0.0, 0.0}, {side, side}, {0.0, 0.0}, nullptr, ratio}}, density);
  std::uint64_t seed = 1;
  for (std::size_t k = 0; k < 2 * particles.count(); ++k) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    const double number = static_cast<double>(seed >> 11) / static_cast<double>(1ull << 53);
    particles.reals(Field::position)[k] += disorder * spacing * (2.0 * number - 1.0);
  }
  for (std::size_t i = 0; i < particles.count(); ++i)
    particles.reals(Field::velocity)[2 * i] = rate * particles.reals(Field::position)[2 * i];
  auto simulation = simulation_of(
      "time.end = 1.0\nsmoothing.kernel = 'truncated-gaussian'\nscheme = { type = 'msph', smoothing_share = 0.0 }\n" +
          metal,
      std::move(particles));
  simulation.step();
  Lower lower;
  lower.names = said(simulation);
  const auto remark = simulation.scheme().closing_remark();
  if (!remark.empty()) {
    const auto at = remark.find("first order in ");
    REQUIRE(std::sscanf(remark.c_str() + at, "first order in %lf and zeroth in %lf", &lower.first, &lower.zeroth) == 2);
  }
  lower.first /= side * side;
  lower.zeroth /= side * side;
  const auto l = by_id(simulation.particles(), Field::velocity_gradient);
  for (std::size_t i = 0; i < l.size() / 4; ++i) lower.error = std::max(lower.error, std::abs(l[4 * i] / rate - 1.0));
  return lower;
}

}  // namespace

TEST_CASE("Kernel correction: a single row of particles has no gradient across it, and the run says so") {
  for (const std::string scheme :
       {"scheme.type = 'total-lagrangian'\n", "scheme = { type = 'eulerian', correction = 'mixed' }\n"})
    for (const int rows : {1, 2, 3}) {
      const auto strip = drawn_strip(scheme, rows);
      WARN(fmt::format("{}{} rows: {:.4f} of the strain rate is seen, a row alone {:.4f} {}", scheme, rows, strip.seen,
                       slope_of_a_row(smoothing_ratio), fmt::join(strip.names, " ")));
      CHECK(strip.names.contains("few-neighbours") == (rows == 1));
      CHECK(strip.seen == Approx(rows == 1 ? slope_of_a_row(smoothing_ratio) : 1.0).epsilon(1e-3));
    }
}

TEST_CASE("MSPH: past which disorder the matrix is singular") {
  // A linear field is exact as long as the expansion is of first order at least.
  struct Case {
    double ratio, disorder;
    bool singular;
  };
  for (const auto& c : {Case{1.5, 1.0, false}, Case{1.2, 1.0, false}, Case{1.2, 2.0, true}, Case{1.0, 0.5, false},
                        Case{1.0, 1.0, true}, Case{0.9, 0.0, true}}) {
    const auto lower = disordered(c.ratio, c.disorder);
    WARN(
        fmt::format("h/δ {}, places off by up to {} δ: first order in {:.2f} %, zeroth in {:.2f} % of the particles; "
                    "largest error {:.0e}",
                    c.ratio, c.disorder, 100.0 * lower.first, 100.0 * lower.zeroth, lower.error));
    CHECK(lower.names.contains("singular-matrix") == c.singular);
    CHECK((lower.error < 1e-4) == (lower.zeroth == 0.0));  // of the step: the strain of half of it
  }
}
