// What every equation of state p(ρ, e) has to be.
#include "physics/eos/eos.hpp"

#include <catch2/catch.hpp>

#include "support/models.hpp"

using namespace tektite;
using test::for_each_sample;

namespace {

/// body(ρ, e) over densities on both sides of the reference and energies from cold to molten. 1.0 itself is left out:
/// there compression and expansion may meet with a corner.
template <class Body>
void for_each_state(const Body& body) {
  for (const double compression : {0.7, 0.9, 0.99, 1.01, 1.1, 1.25, 1.4})
    for (const double energy : {0.0, 1e4, 1e6}) body(compression * test::reference_density, energy);
}

}  // namespace

TEST_CASE("Equations of state: the pressure is zero at the reference state", "[eos]") {
  for_each_sample<Eos>([](const auto& eos) { CHECK(eos.pressure(test::reference_density, 0.0) == 0.0); });
}

TEST_CASE("Equations of state: the derivatives are those of the pressure", "[eos]") {
  for_each_sample<Eos>([](const auto& eos) {
    const double c_squared = eos.pressure_by_density(test::reference_density, 0.0);
    for_each_state([&](double rho, double e) {
      CAPTURE(rho, e);
      // Central differences: (1e-6)² of the third derivative and 1e-16/1e-6 of the value.
      const double dr = 1e-6 * rho;
      const double by_density = (eos.pressure(rho + dr, e) - eos.pressure(rho - dr, e)) / (2.0 * dr);
      CHECK(eos.pressure_by_density(rho, e) == Approx(by_density).margin(1e-8 * c_squared));
      const double de = 1e3;  // J/kg; every model here is at most linear in e, so its size costs nothing
      const double by_energy = (eos.pressure(rho, e + de) - eos.pressure(rho, e - de)) / (2.0 * de);
      CHECK(eos.pressure_by_energy(rho, e) == Approx(by_energy).margin(1e-8 * rho));
    });
  });
}

TEST_CASE("Equations of state: the sound speed is the slope of the isentrope", "[eos]") {
  for_each_sample<Eos>([](const auto& eos) {
    const double scale = eos.pressure_by_density(test::reference_density, 0.0);
    for_each_state([&](double rho, double e) {
      CAPTURE(rho, e);
      const double dr = 1e-6 * rho;
      const double de = eos.pressure(rho, e) / (rho * rho) * dr;  // de = p dρ/ρ² at constant entropy
      const double slope = (eos.pressure(rho + dr, e + de) - eos.pressure(rho - dr, e - de)) / (2.0 * dr);
      CHECK(sound_speed_squared(eos, rho, e) == Approx(slope).margin(1e-8 * scale));
    });
  });
}

TEST_CASE("Equations of state: compression raises the pressure", "[eos]") {
  for_each_sample<Eos>([](const auto& eos) {
    constexpr double energy = 1e4;  // J/kg: a gas without energy has no pressure
    double before = -1e300;
    for (double compression = 0.7; compression < 1.4; compression += 0.01) {
      const double p = eos.pressure(compression * test::reference_density, energy);
      CAPTURE(compression);
      REQUIRE(p > before);
      before = p;
    }
  });
}

TEST_CASE("Equations of state: heat does not lower the pressure", "[eos]") {
  for_each_sample<Eos>([](const auto& eos) {
    for_each_state([&](double rho, double e) { CHECK(eos.pressure_by_energy(rho, e) >= 0.0); });
  });
}

TEST_CASE("Mie-Grüneisen: the pressure on the Hugoniot is ρ0 u_s u_p", "[eos]") {
  // p, ρ and e behind a shock u_s = c0 + S1 u_p into the reference state: ρ/ρ0 = u_s/(u_s - u_p), e = u_p²/2.
  const MieGrueneisen hot{2785.0, 5328.0, 1.338, 2.0};
  const MieGrueneisenCubic cubic{2785.0, 5328.0, 1.338, 0.0, 0.0, 2.0, 0.0};
  for (const double u_p : {100.0, 500.0, 1500.0}) {
    const double u_s = 5328.0 + 1.338 * u_p;
    const double rho = 2785.0 * u_s / (u_s - u_p), e = 0.5 * u_p * u_p, p = 2785.0 * u_s * u_p;
    CHECK(hot.pressure(rho, e) == Approx(p).epsilon(1e-12));  // an identity, so to rounding
    CHECK(cubic.pressure(rho, e) == Approx(p).epsilon(1e-12));
  }
}
