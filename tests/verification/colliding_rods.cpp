// Slow elastic rods along a line: equal ones exchange their velocities within the time that waves take through one and
// back, and one of half the length of the other stops (Saint-Venant), if the contact is as stiff as the rods.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "support/lattice.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

constexpr double spacing = 1e-3, density = 2785.0, bulk = 79e9, shear = 27.6e9;
const double wave_speed = std::sqrt((bulk + 4.0 / 3.0 * shear) / density);

struct Collision {
  double first, second;  ///< mean velocities in the end, over that of the striking rod
  double lasting;        ///< time in contact over that of waves through the first rod and back
  double drift;          ///< of the energy
};

/// Rods of so many particles, the outermost of which start `gap` spacings apart; the run lasts that many times as long
/// as waves take through the first and back.
Collision collide(const std::string& scheme, const std::string& contact, int first, int second, double speed,
                  double gap, double lasts) {
  const double through = 2.0 * first * spacing / wave_speed;
  auto run = simulation_of(
      fmt::format("time.end = {}\nviscosity = {{ alpha = 0.05, beta = 0.0 }}\nscheme.type = '{}'\ncontact = {{ {} }}\n"
                  "[material.metal]\ndensity = {}\neos = {{ model = 'linear', bulk_modulus = {} }}\n"
                  "strength = {{ model = 'elastic', shear_modulus = {} }}\n",
                  gap * spacing / speed + lasts * through, scheme, contact, density, bulk, shear),
      particles_on(Space::line,
                   {{"striker", "metal", spacing, {0.0}, {first}, {speed}},
                    {"struck", "metal", spacing, {(first - 1.0 + gap) * spacing}, {second}, {0.0}}},
                   density));
  double from = 0.0, to = 0.0;
  while (!run.finished()) {
    run.step();
    if (!(run.ledger().contact > 0.0)) continue;
    if (from == 0.0) from = run.time();
    to = run.time();
  }
  const auto v = by_id(run.particles(), Field::velocity);
  Collision result{0.0, 0.0, (to - from) / through, run.energy_drift(run.ledger())};
  for (int i = 0; i < first + second; ++i)
    (i < first ? result.first : result.second) +=
        v[static_cast<std::size_t>(i)] / ((i < first ? first : second) * speed);
  return result;
}

}  // namespace

TEST_CASE("Rods: where contact begins at the faces, slow elastic rods part as waves let them", "[contact]") {
  for (const std::string scheme : {"total-lagrangian", "eulerian"})
    for (const double speed : {5.0, 50.0}) {
      const std::string at_faces = "begins = 'at-faces'";
      const auto alike = collide(scheme, at_faces, 100, 100, speed, 1.1, 3.0),
                 shorter = collide(scheme, at_faces, 50, 100, speed, 1.1, 4.0),
                 in_reach = collide(scheme, "begins = 'in-reach'", 50, 100, speed, 3.0, speed > 10.0 ? 8.0 : 40.0);
      WARN(
          fmt::format("{} at {} m/s: {:.4f} and {:.4f} after {:.3f}, drift {:.1e}; of half the length {:.4f} after "
                      "{:.3f}; in reach {:.4f} after {:.3f}",
                      scheme, speed, alike.first, alike.second, alike.lasting, alike.drift, shorter.first,
                      shorter.lasting, in_reach.first, in_reach.lasting));
      CHECK(std::abs(alike.first) < 0.02);
      CHECK(alike.second == Approx(1.0).margin(0.02));
      CHECK(alike.lasting == Approx(1.0).margin(0.1));
      CHECK(std::abs(alike.drift) < 5e-3);  // of the leapfrog: 2.4e-3, and 3e-4 and 6e-5 with half and a quarter of C
      CHECK(std::abs(shorter.first) < 0.04);
      CHECK(in_reach.first < -0.2);  // as rigid rods do, -1/3
    }
}
