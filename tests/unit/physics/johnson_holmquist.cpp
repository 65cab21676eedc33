// The ceramic of Johnson and Holmquist: its strength, intact and failed, and when it fails.
#include <catch2/catch.hpp>
#include <limits>

#include "passes/damage.hpp"
#include "support/models.hpp"
#include "support/random_step.hpp"

using namespace tektite;

namespace {

const auto strength = test::model_from<Strength, JohnsonHolmquist>(test::Samples<JohnsonHolmquist>::all[0]);
const auto damage = test::model_from<Damage, JohnsonHolmquistDamage>(test::Samples<JohnsonHolmquistDamage>::all[0]);

/// Flow stress in Pa at a pressure in GPa and a damage, at rates up to the reference.
double flow_stress(double pressure, double damaged) {
  return strength.flow_stress({0.0, 0.0, 0.0, 1e9 * pressure, damaged});
}

}  // namespace

TEST_CASE("Johnson-Holmquist: the intact strength is linear between the points of the table", "[ceramic]") {
  CHECK(flow_stress(-0.75, 0.0) == 0.0);
  CHECK(flow_stress(-1.0, 0.0) == 0.0);
  CHECK(flow_stress(2.5, 0.99) == Approx(7.1e9));
  CHECK(flow_stress(10.0, 0.0) == Approx(12.2e9));
  CHECK(flow_stress(50.0, 0.0) == Approx(12.2e9));
  CHECK(flow_stress(0.5 * (2.5 - 0.75), 0.0) == Approx(0.5 * 7.1e9));
  CHECK(flow_stress(6.25, 0.0) == Approx(0.5 * (7.1e9 + 12.2e9)));
}

TEST_CASE("Johnson-Holmquist: failed, it bears shear in proportion to the pressure, up to a limit", "[ceramic]") {
  CHECK(flow_stress(-0.5, 1.0) == 0.0);
  CHECK(flow_stress(0.0, 1.0) == 0.0);
  CHECK(flow_stress(1.0, 1.0) == Approx(0.4e9));
  CHECK(flow_stress(10.0, 1.0) == Approx(1.3e9));
}

TEST_CASE("Johnson-Holmquist: rates above the reference raise the strength by the logarithm", "[ceramic]") {
  const double at_rest = flow_stress(2.5, 0.0);
  CHECK(strength.flow_stress({0.0, 1e5, 0.0, 2.5e9, 0.0}) == Approx(at_rest * (1.0 + 0.009 * std::log(1e5))));
}

TEST_CASE("Johnson-Holmquist: the failure strain rises with the pressure from the tensile limit on", "[ceramic]") {
  const auto strain = [](double pressure) { return damage.failure_strain({0.0, 0.0, 0.0, 1e9 * pressure}); };
  CHECK(strain(-0.75) == 0.0);
  CHECK(strain(99.75) == Approx(0.8));
  CHECK(strain(200.0) == Approx(0.8));
  CHECK(strain(0.5 * (99.75 - 0.75)) == Approx(0.4));
}

TEST_CASE("Johnson-Holmquist: at the tensile limit it fails at once, without plastic strain", "[ceramic]") {
  const double increment = 0.0;
  const auto stress = Symmetric<double, 2>::zero();
  for (const double pressure : {-0.74e9, -0.75e9}) {
    double d = 0.3;
    AdvanceDamage<JohnsonHolmquistDamage, 2>{damage, &increment, &pressure, &stress, nullptr, 1e-8, &d}(0);
    CHECK(d == (pressure <= -0.75e9 ? 1.0 : 0.3));
  }
}

TEST_CASE("Johnson-Holmquist: bulking keeps a share of the lost elastic energy as that of compression", "[ceramic]") {
  auto bulking = damage;
  constexpr double bulk_modulus = 220e9, lost = 1e8;
  for (const double share : {0.0, 0.5, 1.0})
    for (const double pressure : {0.0, 1e9, 20e9}) {
      bulking.bulking = share;
      const double after = pressure + bulking.bulking_pressure(pressure, bulk_modulus, lost);
      CHECK((after * after - pressure * pressure) / (2.0 * bulk_modulus) == Approx(share * lost).epsilon(1e-9));
    }
  // Nothing bears tension once it has failed, so that there is no energy of it to count from.
  CHECK(bulking.bulking_pressure(-0.5e9, bulk_modulus, lost) == bulking.bulking_pressure(0.0, bulk_modulus, lost));
}

TEST_CASE("Johnson-Holmquist: what fails bulks once, and what does not fail never", "[ceramic]") {
  auto bulking = damage;
  bulking.bulking = 1.0;
  const double bulk_modulus = 220e9, pressure = 2e9, equivalent = 5e9;
  const Symmetric<double, 2> stress{{equivalent / 1.5, -0.5 * equivalent / 1.5, -0.5 * equivalent / 1.5, 0.0}};
  REQUIRE(von_mises(stress) == Approx(equivalent));
  double increment = 1e-4, d = 0.0, added = 0.0;
  const AdvanceDamageAndBulk<JohnsonHolmquistDamage, JohnsonHolmquist, 2> pass{
      {bulking, &increment, &pressure, &stress, nullptr, 1e-8, &d}, strength, bulk_modulus, &added};
  pass(0);
  CHECK(d > 0.0);
  CHECK(d < 1.0);
  CHECK(added == 0.0);
  increment = 1.0;
  pass(0);
  CHECK(d == 1.0);
  // From 5 GPa to the failed strength 0.4 P: ΔU = (σ² - σ_f²)/(6 G) by hand.
  const double lost = (25e18 - 0.64e18) / (6.0 * 193e9);
  CHECK(added == Approx(std::sqrt(4e18 + 2.0 * bulk_modulus * lost) - 2e9));
  const double once = added;
  pass(0);
  CHECK(added == once);
}

TEST_CASE("Johnson-Holmquist: what fails drops to its failed strength in the next step", "[ceramic]") {
  test::Random random(9);
  auto state = test::start_of<2>(strength);
  state.pressure = 2e9;
  const auto rest = Tensor<double, 2>::zero();
  state.stress = random.symmetric<2>(1e9);
  state.stress = (5e9 / von_mises(deviator(state.stress))) * deviator(state.stress);
  advance_deviator(strength, rest, 0.0, 3215.0, 1e-8, state);
  CHECK(von_mises(state.stress) == Approx(5e9).epsilon(1e-12));  // elastic: nothing changes
  state.damage = 1.0;
  advance_deviator(strength, rest, 0.0, 3215.0, 1e-8, state);
  const double rate = state.plastic_strain / 1e-8;
  CHECK(von_mises(state.stress) == Approx(0.8e9 * (1.0 + 0.009 * std::log(rate))).epsilon(1e-9));
}
