// Shocks of equations of state and the pressure of an impact, by which tektite check judges a scene.
#include <catch2/catch.hpp>

#include "advice/impact.hpp"

using namespace tektite;

namespace {

MieGrueneisen aluminium() { return {2785.0, 5328.0, 1.338, 2.0}; }

}  // namespace

TEST_CASE("Hugoniot: Mie-Grüneisen about u_s = c0 + s u_p gives it back", "[advice]") {
  for (const double up : {1.0, 100.0, 1000.0, 4000.0}) {
    const auto shock = shock_of_speed(aluminium(), up);
    REQUIRE(shock);
    const double us = 5328.0 + 1.338 * up;
    CHECK(shock->shock_speed == Approx(us).epsilon(1e-9));
    CHECK(shock->pressure == Approx(2785.0 * us * up).epsilon(1e-9));
  }
}

TEST_CASE("Hugoniot: an impact of equals moves both by half, an impact of unequals has one pressure", "[advice]") {
  const auto equal = match_impedances(aluminium(), aluminium(), 3100.0);
  REQUIRE(equal);
  CHECK(equal->first.particle_speed == Approx(1550.0));
  const LinearEos steel{7870.0, 166.7e9};
  const auto unequal = match_impedances(steel, aluminium(), 3100.0);
  REQUIRE(unequal);
  CHECK(unequal->first.pressure == Approx(unequal->second.pressure));
  CHECK(unequal->first.particle_speed + unequal->second.particle_speed == Approx(3100.0));
  CHECK(unequal->first.particle_speed < unequal->second.particle_speed);
}

TEST_CASE("Hugoniot: what an equation of state cannot be compressed to has no shock", "[advice]") {
  const IdealGas gas{1.0, 1.4};
  CHECK_FALSE(shock_of_speed(gas, 1000.0));  // without energy it has no pressure
  const PolynomialEos softening{2785.0, 80e9, -400e9, 0.0};
  CHECK_FALSE(match_impedances(softening, softening, 4000.0));
}

TEST_CASE("Hugoniot: release keeps the waste heat, exactly where pressure hangs on density alone", "[advice]") {
  const LinearEos steel{7870.0, 166.7e9};
  const auto shock = *shock_of_speed(steel, 1000.0);
  // ∫ p dρ/ρ² from ρ0 to ρ with p = K (ρ/ρ0 - 1); the rest of the shock's energy stays.
  const double ratio = shock.density / 7870.0;
  const double given_back = 166.7e9 / 7870.0 * (std::log(ratio) + 1.0 / ratio - 1.0);
  CHECK(energy_after_release(steel, shock) == Approx(shock.energy - given_back).epsilon(1e-3));
  // Weak shocks are isentropic to the third order of u_p; aluminium from 78 GPa is left above its melting point.
  const auto slow = *shock_of_speed(aluminium(), 10.0), fast = *shock_of_speed(aluminium(), 3000.0);
  CHECK(energy_after_release(aluminium(), slow) < 0.01 * slow.energy);
  CHECK(energy_after_release(aluminium(), fast) / 875.0 > 933.0 - 298.0);
}
