// An elastic ball that falls on a rigid anvil: time in contact, largest force and speed of return after Hertz (Johnson
// 1985, Contact Mechanics, section 11.4), where the particles follow its round face.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "support/lattice.hpp"

using namespace tektite;

namespace {

constexpr double radius = 10e-3, density = 7850.0, speed = 10.0;  // m, kg/m³, m/s
constexpr double young = 200e9, poisson = 0.3;                    // Pa
constexpr double spacing = 0.5e-3;

/// Half of a section through the ball, on circles half a spacing off its surface; the lowest particle is half a spacing
/// above y = 0 or little more.
Particles ball() {
  struct Point {
    double x, y, section;
  };
  std::vector<Point> points;
  for (double r = radius - 0.5 * spacing; r > 0.0; r -= spacing) {
    const auto count = std::lround(M_PI * r / spacing);
    for (long k = 0; k < count; ++k) {
      const double angle = M_PI * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
      points.push_back(
          {r * std::sin(angle), radius - r * std::cos(angle), M_PI * r * spacing / static_cast<double>(count)});
    }
  }
  auto p = test::particles_on(
      Space::axisymmetric,
      {{"ball", "steel", spacing, {0.0, 0.0}, {static_cast<int>(points.size()), 1}, {0.0, -speed}}}, density);
  for (std::size_t i = 0; i < p.count(); ++i) {
    p.vectors<2>(Field::position)[i] = {points[i].x, points[i].y};
    p.reals(Field::mass)[i] = density * 2.0 * M_PI * points[i].x * points[i].section;
  }
  return p;
}

}  // namespace

TEST_CASE("Hertz: a ball on circles of particles rebounds from the anvil in time and with its speed", "[contact]") {
  auto p = ball();
  double mass = 0.0;
  for (const double m : p.reals(Field::mass)) mass += m;
  CHECK(mass == Approx(density * 4.0 / 3.0 * M_PI * std::pow(radius, 3)).epsilon(2e-3));
  const double modulus = young / (1.0 - poisson * poisson);
  const double depth = std::pow(15.0 * mass * speed * speed / (16.0 * std::sqrt(radius) * modulus), 0.4);  // m
  const double contact = 2.943 * depth / speed;                                                            // s
  const double force = 4.0 / 3.0 * modulus * std::sqrt(radius) * std::pow(depth, 1.5);                     // N

  auto run = test::simulation_of(
      "scheme.type = 'total-lagrangian'\nanvil = { axis = 'y', at = " + std::to_string(0.5 * spacing) +
          " }\ntime.end = " + std::to_string(2.0 * contact) + "\n[material.steel]\ndensity = 7850.0\n" +
          "eos = { model = 'linear', bulk_modulus = " + std::to_string(young / 3.0 / (1.0 - 2.0 * poisson)) +
          " }\nstrength = { model = 'elastic', shear_modulus = " + std::to_string(young / 2.0 / (1.0 + poisson)) +
          " }\n",
      std::move(p));
  // Momentum over time; the force is that of a twentieth of the contact, which is longer than waves take through the
  // ball and back.
  std::vector<std::pair<double, double>> states;
  while (!run.finished()) {
    states.emplace_back(run.time(), run.ledger().momentum[1]);
    run.step();
  }
  const double first = states.front().second, last = states.back().second;
  CHECK(last == Approx(-first).epsilon(0.05));
  double begun = 0.0, over = 0.0, largest = 0.0;
  std::size_t from = 0;
  for (const auto& [time, momentum] : states) {
    const double share = (momentum - first) / (last - first);
    if (share < 1e-3) begun = time;
    if (share < 0.999) over = time;
    while (time - states[from].first > 0.05 * contact) ++from;
    if (from > 0) largest = std::max(largest, (momentum - states[from].second) / (time - states[from].first));
  }
  // Between these shares of the momentum lie 0.934 of Hertz's time. The contact is two spacings in radius here; with
  // half the spacing both are within 6 %.
  CHECK(over - begun == Approx(0.934 * contact).epsilon(0.1));
  CHECK(largest == Approx(force).epsilon(0.1));
}
