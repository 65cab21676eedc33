// What damage does: when a particle fails, and what it bears then.
#include "physics/damage/damage.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "passes/damage.hpp"
#include "support/models.hpp"

using namespace tektite;

namespace {

constexpr double dt = 1e-8;  // s

/// Damage after `steps` steps of plastic strain `increment` under a pressure and a uniaxial deviator of 1 MPa.
template <class Model>
double damage_after(const Model& model, int steps, double increment, double pressure) {
  Symmetric<double, 3> stress{{2e6 / 3.0, -1e6 / 3.0, -1e6 / 3.0, 0.0, 0.0, 0.0}};  // equivalent stress 1 MPa
  double damage = 0.0;
  const AdvanceDamage<Model, 3> pass{model, &increment, &pressure, &stress, nullptr, dt, &damage};
  for (int k = 0; k < steps; ++k) pass(0);
  return damage;
}

}  // namespace

TEST_CASE("Johnson-Cook damage: the failure strain is the formula's", "[damage]") {
  const auto model = test::model_from<Damage, JohnsonCookDamage>(test::Samples<JohnsonCookDamage>::all[1]);
  // 4340 steel: (0.05 + 3.44 exp(-2.12 · 0.5)) (1 + 0.002 ln 1000) (1 + 0.61 · 0.5) by hand
  const double by_hand = (0.05 + 3.44 * 0.34645581033005734) * (1.0 + 0.002 * 6.907755278982137) * 1.305;
  const double half_way = 0.5 * (298.0 + 1793.0);
  CHECK(model.failure_strain({0.5, 1000.0, half_way}) == Approx(by_hand).epsilon(1e-12));
}

TEST_CASE("Johnson-Cook damage: a material of constant failure strain fails at that strain", "[damage]") {
  const auto model = test::model_from<Damage, JohnsonCookDamage>("d1 = 0.45");
  CHECK(damage_after(model, 44, 0.01, 0.0) == Approx(44.0 / 45.0).epsilon(1e-12));
  CHECK(damage_after(model, 46, 0.01, 0.0) == 1.0);
}

TEST_CASE("Johnson-Cook damage: tension hastens it where D3 is negative", "[damage]") {
  const auto model = test::model_from<Damage, JohnsonCookDamage>("d1 = 0.1\nd2 = 1.0\nd3 = -1.5");
  CHECK(damage_after(model, 1, 0.01, -1e6) > damage_after(model, 1, 0.01, 0.0));
  CHECK(damage_after(model, 1, 0.01, 0.0) > damage_after(model, 1, 0.01, 1e6));
}

TEST_CASE("Johnson-Cook damage: what has lost its strength fails by its strain all the same", "[damage]") {
  const Symmetric<double, 3> molten = Symmetric<double, 3>::zero();
  const double pressure = GENERATE(-1e9, 0.0, 1e9), increment = 0.01;
  INFO(pressure);
  const auto after_a_step = [&](const std::string& keys) {
    double damage = 0.0;
    const auto model = test::model_from<Damage, JohnsonCookDamage>(keys);
    AdvanceDamage<JohnsonCookDamage, 3>{model, &increment, &pressure, &molten, nullptr, dt, &damage}(0);
    return damage;
  };
  CHECK(after_a_step("d1 = 0.45") == Approx(0.01 / 0.45).epsilon(1e-12));
  CHECK(after_a_step("d1 = 0.45\nd3 = -1.5") == Approx(0.01 / 0.45).epsilon(1e-12));
  const double most = pressure < 0.0 ? 0.01 / 0.1 : pressure == 0.0 ? 0.01 / 1.1 : 0.0;
  CHECK(after_a_step("d1 = 0.1\nd2 = 1.0\nd3 = -1.5") == Approx(most).margin(1e-100).epsilon(1e-12));
}

TEST_CASE("Damage: without plastic strain there is none, and it never falls", "[damage]") {
  test::for_each_sample<Damage>([](const auto& model) {
    if constexpr (!std::is_same_v<std::decay_t<decltype(model)>, NoDamage>) {
      CHECK(damage_after(model, 5, 0.0, 0.0) == 0.0);
      CHECK(damage_after(model, 3, 0.001, 0.0) > damage_after(model, 2, 0.001, 0.0));
    }
  });
}

TEST_CASE("Failure: a failed particle bears pressure, but neither shear nor tension", "[damage]") {
  const double damage[2] = {1.0, 0.999};
  Symmetric<double, 2> stress[2] = {{{1e6, -1e6, 0.0, 2e6}}, {{1e6, -1e6, 0.0, 2e6}}};
  const ReleaseShear<2> release{damage, stress};
  release(0);
  release(1);
  CHECK(contract(stress[0], stress[0]) == 0.0);
  CHECK(contract(stress[1], stress[1]) > 0.0);

  double pressure[2] = {-3e8, -3e8};
  const LimitTension limit{-2e8, damage, pressure};
  limit(0);
  limit(1);
  CHECK(pressure[0] == 0.0);
  CHECK(pressure[1] == -2e8);
  double compressed = 5e8;
  LimitTension{-2e8, damage, &compressed}(0);
  CHECK(compressed == 5e8);
}
