// The time-split Godunov scheme with the mixed correction: a linear velocity field on any arrangement, up to the
// boundary; no motion out of nothing, in thin strips and in a ring that flows.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/tensor_algebra.hpp"
#include "passes/across.hpp"
#include "support/lattice.hpp"
#include "support/random_step.hpp"
#include "support/ring.hpp"

using namespace tektite;

namespace {

constexpr double spacing = 1e-3;

/// A block at rest without stress, disordered by a fifth of the spacing and with disordered masses, whose velocities
/// are L x.
template <int D>
Particles linear_motion(Space space, const Tensor<double, D>& l) {
  const int side = D == 3 ? 6 : 9;
  auto p = test::particles_on(space,
                              {{"block", "metal", spacing, std::vector<double>(D, 0.0), std::vector<int>(D, side),
                                std::vector<double>(D, 0.0)}},
                              2785.0);
  test::Random random(D);
  for (auto& x : p.reals(Field::position)) x += random.between(-0.2, 0.2) * spacing;
  for (auto& m : p.reals(Field::mass)) m *= random.between(0.8, 1.2);
  for (std::size_t i = 0; i < p.count(); ++i)
    p.vectors<D>(Field::velocity)[i] = times(l, p.vectors<D>(Field::position)[i]);
  return p;
}

template <int D>
void check_linear_motion(Space space, const std::string& scheme) {
  INFO(name_of(space) << " " << scheme);
  test::Random random(7);
  const auto l = random.gradient<D>(100.0);  // 1/s
  Simulation simulation =
      test::simulation_of("time.end = 1.0\nscheme = { type = 'godunov-split', correction = 'mixed', " + scheme +
                              " }\n[material.metal]\ndensity = 2785.0\n"
                              "eos = { model = 'linear', bulk_modulus = '79 GPa' }\n"
                              "strength = { model = 'elastic', shear_modulus = '27.6 GPa' }\n",
                          linear_motion(space, l));
  const Particles& p = simulation.particles();
  const auto gradients = p.reals(Field::velocity_gradient);
  for (std::size_t i = 0; i < gradients.size(); ++i) CHECK(gradients[i] == Approx(l.c[i % (D * D)]).margin(1e-9));
  simulation.step();
  const double expected = 2785.0 * density_factor(simulation.last_step().dt * trace(l));
  for (const double rho : p.reals(Field::density)) CHECK(rho == Approx(expected).epsilon(1e-14));
}

/// A strip of elastic copper, 60 particles long and `rows` thick, whose right half moves away from the left one at 5
/// m/s.
Simulation stretched_strip(int rows, double courant) {
  auto p = test::particles_on(Space::plane_strain,
                              {{"strip", "copper", spacing, {0.5 * spacing, 0.5 * spacing}, {60, rows}, {0.0, 0.0}}},
                              8930.0);
  for (std::size_t i = 0; i < p.count(); ++i)
    if (p.reals(Field::position)[2 * i] > 30.0 * spacing) p.reals(Field::velocity)[2 * i] = 5.0;
  return test::simulation_of("time.end = '60 us'\nscheme = { type = 'godunov-split', correction = 'mixed', courant = " +
                                 std::to_string(courant) + " }\n[material.copper]\ndensity = 8930.0\n" +
                                 "eos = { model = 'linear', bulk_modulus = '138 GPa' }\n"
                                 "strength = { model = 'elastic', shear_modulus = '47.7 GPa' }\n",
                             std::move(p));
}

/// The ring of test::Ring on nine circles of particles.
Simulation collapsing_ring(const test::Ring& ring) {
  constexpr int circles = 9;
  const double across = (ring.outer - ring.inner) / circles;
  std::vector<std::pair<double, double>> places;  // radius, angle
  for (int k = 0; k < circles; ++k) {
    const double radius = ring.inner + (k + 0.5) * across;
    const auto count = std::lround(2.0 * M_PI * radius / across);
    for (long n = 0; n < count; ++n)
      places.emplace_back(radius, 2.0 * M_PI * static_cast<double>(n) / static_cast<double>(count));
  }
  auto p = test::particles_on(
      Space::plane_strain,
      {{"ring", "beryllium", across, {0.0, 0.0}, {static_cast<int>(places.size()), 1}, {0.0, 0.0}, nullptr, 1.2}},
      ring.density);
  for (std::size_t i = 0; i < p.count(); ++i) {
    const auto [radius, angle] = places[i];
    const double speed = ring.speed * ring.inner / radius, count = std::round(2.0 * M_PI * radius / across);
    p.vectors<2>(Field::position)[i] = {radius * std::cos(angle), radius * std::sin(angle)};
    p.vectors<2>(Field::velocity)[i] = {-speed * std::cos(angle), -speed * std::sin(angle)};
    p.reals(Field::mass)[i] = ring.density * 2.0 * M_PI * radius * across / count;
  }
  return test::simulation_of(
      "time.end = '130 us'\nscheme = { type = 'godunov-split', correction = 'mixed', courant = 0.5 }\n"
      "[material.beryllium]\ndensity = 1845.0\n"
      "eos = { model = 'mie-grueneisen', bulk_sound_speed = 12870.0, hugoniot_slope = 1.124, grueneisen = 2.0 }\n"
      "strength = { model = 'perfectly-plastic', shear_modulus = '151 GPa', yield_stress = '330 MPa' }\n",
      std::move(p));
}

}  // namespace

TEST_CASE("Corrected Godunov sums: a linear velocity field has its gradient and its divergence", "[godunov]") {
  for (const std::string scheme : {"order = 1", "order = 2", "splitting = 'strang'"}) {
    check_linear_motion<1>(Space::line, scheme);
    check_linear_motion<2>(Space::plane_strain, scheme);
    check_linear_motion<3>(Space::solid, scheme);
  }
}

TEST_CASE("Corrected Godunov sums: an elastic strip of few rows keeps ringing and gains no motion", "[godunov]") {
  for (const int rows : {2, 3, 4, 6})
    for (const double courant : {0.25, 0.5}) {
      INFO(rows << " rows, C = " << courant);
      auto run = stretched_strip(rows, courant);
      const double before = run.ledger().kinetic;
      double largest = 0.0;
      while (!run.finished()) {
        run.step();
        largest = std::max(largest, run.ledger().kinetic);
      }
      CHECK(largest < 1.001 * before);
      // 2.5 m/s of the whole stay, three quarters of the energy are no less than a half of the rest.
      CHECK(run.ledger().kinetic > 0.75 * before);
    }
}

TEST_CASE("Corrected Godunov sums: a ring that collapses turns its energy into plastic work and stops where it should",
          "[godunov]") {
  test::Ring exact{1845.0, 330e6, 0.08, 0.1, 417.1};
  auto run = collapsing_ring(exact);
  const double before = run.ledger().kinetic;
  test::run_to_the_end(run);
  exact.advance_to(200e-6);
  const auto& p = run.particles();
  // A particle that starts at r is in the end at √(r² - a0² + a²): the mean over the innermost circle.
  const double across = 0.02 / 9.0, start = 0.08 + 0.5 * across;
  const auto innermost = std::lround(2.0 * M_PI * start / across);
  std::vector<double> radii;
  for (std::size_t i = 0; i < p.count(); ++i) radii.push_back(norm(p.vectors<2>(Field::position)[i]));
  std::ranges::sort(radii);
  const double radius = std::accumulate(radii.begin(), radii.begin() + innermost, 0.0) / static_cast<double>(innermost);
  const double stops = std::sqrt(start * start - 0.08 * 0.08 + exact.inner * exact.inner);
  CHECK(radius == Approx(stops).epsilon(3e-3));
  CHECK(run.ledger().plastic == Approx(before).epsilon(5e-3));  // a thousandth is elastic, more is heat of waves
}
