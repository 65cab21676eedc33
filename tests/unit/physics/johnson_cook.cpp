#include "physics/strength/johnson_cook.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "physics/strength/advance_deviator.hpp"
#include "physics/strength/perfectly_plastic.hpp"
#include "support/random_step.hpp"

using namespace tektite;

namespace {

/// Round numbers, so that the flow stress can be worked out by hand.
JohnsonCook round_model() {
  JohnsonCook model;
  model.shear_modulus = 50e9;
  model.a = 400e6;
  model.b = 100e6;
  model.n = 0.5;
  model.c = 0.1;
  model.m = 2.0;
  model.reference_rate = 10.0;
  model.room_temperature = 300.0;
  model.melting_temperature = 1300.0;
  model.specific_heat = 500.0;
  model.taylor_quinney = 0.9;
  return model;
}

constexpr double e_squared = std::numbers::e * std::numbers::e;

}  // namespace

TEST_CASE("Johnson-Cook: the flow stress is that of hand calculation", "[johnson_cook]") {
  const auto model = round_model();
  CHECK(model.flow_stress({0.0, 0.0, 300.0}) == Approx(400e6).epsilon(1e-15));
  CHECK(model.flow_stress({0.25, 0.0, 300.0}) == Approx(450e6).epsilon(1e-15));               // 400 + 100·0.5
  CHECK(model.flow_stress({0.25, 10.0 * e_squared, 300.0}) == Approx(540e6).epsilon(1e-14));  // ·(1 + 0.1·2)
  CHECK(model.flow_stress({0.25, 10.0 * e_squared, 800.0}) == Approx(405e6).epsilon(1e-14));  // ·(1 - 0.5²)
}

TEST_CASE("Johnson-Cook: molten material has no strength, cold material no more than at room temperature",
          "[johnson_cook]") {
  const auto model = round_model();
  CHECK(model.flow_stress({0.5, 1e6, 1300.0}) == 0.0);
  CHECK(model.flow_stress({0.5, 1e6, 5000.0}) == 0.0);
  CHECK(model.flow_stress({0.5, 1e6, 1299.0}) > 0.0);
  CHECK(model.flow_stress({0.5, 1e6, 100.0}) == model.flow_stress({0.5, 1e6, 300.0}));
}

TEST_CASE("Johnson-Cook: below the reference rate the rate does not matter", "[johnson_cook]") {
  const auto model = round_model();
  CHECK(model.flow_stress({0.1, 1e-9, 300.0}) == model.flow_stress({0.1, 10.0, 300.0}));
  CHECK(model.flow_stress({0.1, 11.0, 300.0}) > model.flow_stress({0.1, 10.0, 300.0}));
}

TEST_CASE("Johnson-Cook: molten material loses all its shear stress in a step", "[johnson_cook]") {
  const auto model = round_model();
  DeviatorState<1> state{{{2e8, -1e8, -1e8}}, 0.0, 0.0, 1400.0};
  advance_deviator(model, Tensor<double, 1>::zero(), 0.0, 8000.0, 1e-8, state);
  CHECK(von_mises(state.stress) <= 1e-6);  // Pa, of 3e8
  CHECK(state.plastic_strain == Approx(3e8 / (3.0 * 50e9)).epsilon(1e-12));
}

TEST_CASE("Johnson-Cook: the part χ of the plastic work warms", "[johnson_cook]") {
  const auto model = round_model();
  test::Random random(1);
  auto state = test::start_of<3>(model);
  for (int step = 0; step < 200; ++step)
    advance_deviator(model, random.gradient<3>(0.02 / 1e-8), 0.0, 8000.0, 1e-8, state);
  CHECK(state.temperature > 310.0);
  CHECK(500.0 * (state.temperature - 300.0) == Approx(0.9 * state.plastic_work).epsilon(1e-12));
}

TEST_CASE("Johnson-Cook: without hardening, rate and heat it is perfectly plastic", "[johnson_cook]") {
  auto model = round_model();
  model.b = model.c = model.taylor_quinney = 0.0;
  const PerfectlyPlastic ideal{model.shear_modulus, model.a};
  test::Random random(2);
  auto state = test::start_of<3>(model);
  auto ideal_state = test::start_of<3>(ideal);
  for (int step = 0; step < 200; ++step) {
    const auto l = random.gradient<3>(0.01 / 1e-8);
    advance_deviator(model, l, 0.0, 8000.0, 1e-8, state);
    advance_deviator(ideal, l, 0.0, 8000.0, 1e-8, ideal_state);
  }
  CHECK(von_mises(state.stress - ideal_state.stress) <= 1e-6 * model.a);  // the root's 1e-12 of the trial, 200 times
  CHECK(state.plastic_strain == Approx(ideal_state.plastic_strain).epsilon(1e-9));
}
