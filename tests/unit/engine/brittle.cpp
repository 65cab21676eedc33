// A material that does not yield may fail by what its pressure does: Johnson and Holmquist's tensile limit.
#include <catch2/catch.hpp>

#include "support/lattice.hpp"

using namespace tektite;

namespace {

constexpr double reference_density = 1000.0;  // kg/m³

/// A block at this density, after some steps of a scheme.
Simulation block_at(double density, const std::string& scheme, const std::string& strength) {
  const std::string scene = "time.end = 1.0\nscheme.type = '" + scheme + "'\n[material.glass]\ndensity = 1000.0\n" +
                            "eos = { model = 'linear', bulk_modulus = '1 GPa' }\nstrength = { " + strength + " }\n" +
                            "damage = { model = 'johnson-holmquist-1', tensile_limit = '-5 MPa', most_strain = 0.8, " +
                            "most_pressure = '1 GPa', bulking = 1.0 }\n";
  auto particles = test::particles_on(Space::plane_strain, {{"block", "glass", 1e-3, {0.0, 0.0}, {10, 10}, {0.0, 0.0}}},
                                      reference_density);
  std::ranges::fill(particles.reals(Field::density), density);
  auto simulation = test::simulation_of(scene, std::move(particles));
  test::take_steps(simulation, 3);
  return simulation;
}

}  // namespace

TEST_CASE("Damage: what does not yield fails at the tensile limit, and not before", "[damage]") {
  const std::string scheme = GENERATE("eulerian", "godunov-split");
  const std::string strength = GENERATE("model = 'none'", "model = 'elastic', shear_modulus = '0.5 GPa'");
  INFO(scheme << ", " << strength);
  // p = K (ρ/ρ0 - 1): -10 MPa lies beyond the limit and -1 MPa, of which waves add less than twice as much, within it.
  const auto torn = block_at(0.99 * reference_density, scheme, strength);
  const auto whole = block_at(0.999 * reference_density, scheme, strength);
  CHECK(std::ranges::min(torn.particles().reals(Field::damage)) == 1.0);
  CHECK(std::ranges::min(torn.particles().reals(Field::pressure)) >= 0.0);
  CHECK(std::ranges::max(whole.particles().reals(Field::damage)) == 0.0);
  CHECK(std::ranges::min(whole.particles().reals(Field::pressure)) < -0.5e6);
}
