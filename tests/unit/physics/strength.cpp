// What every strength model has to do in a step, however large.
#include "physics/strength/strength.hpp"

#include <catch2/catch.hpp>

#include "physics/strength/advance_deviator.hpp"
#include "support/models.hpp"
#include "support/random_step.hpp"

using namespace tektite;
using test::for_each_sample;

namespace {

constexpr double dt = 1e-8;  // s

/// body(model, dimension) for every sample in one, two and three dimensions.
template <class Body>
void for_each_strength(const Body& body) {
  for_each_sample<Strength>([&](const auto& model) {
    body(model, std::integral_constant<int, 1>{});
    body(model, std::integral_constant<int, 2>{});
    body(model, std::integral_constant<int, 3>{});
  });
}

/// body(before, L, after) for many random steps of strain 1e-5 to 1 in a row.
template <int D, class Model, class Body>
void walk(const Model& model, const Body& body) {
  test::Random random(D);
  auto state = test::start_of<D>(model);
  for (int step = 0; step < 500; ++step) {
    const auto before = state;
    const auto l = random.gradient<D>(random.magnitude(1e-5, 1.0) / dt);
    advance_deviator(model, l, 0.0, test::reference_density, dt, state);
    CAPTURE(D, step);
    body(before, l, state);
  }
}

constexpr std::size_t width = wide_pack_width;

/// number(k) in lane k.
template <class Number>
WidePack in_lanes(const Number& number) {
  return WidePack([&](auto lane) { return number(static_cast<std::size_t>(lane)); });
}

/// The states state(k) after a step under the velocity gradients l(k), side by side.
template <int D, class Model, class Gradient, class State>
DeviatorState<D, WidePack> advanced(const Model& model, const Gradient& l, const State& state) {
  Tensor<WidePack, D> gradient;
  for (int c = 0; c < D * D; ++c) gradient.c[c] = in_lanes([&](std::size_t k) { return l(k).c[c]; });
  DeviatorState<D, WidePack> states;
  for (int c = 0; c < states.stress.size; ++c)
    states.stress.c[c] = in_lanes([&](std::size_t k) { return state(k).stress.c[c]; });
  states.plastic_strain = in_lanes([&](std::size_t k) { return state(k).plastic_strain; });
  states.plastic_work = in_lanes([&](std::size_t k) { return state(k).plastic_work; });
  states.temperature = in_lanes([&](std::size_t k) { return state(k).temperature; });
  states.pressure = in_lanes([&](std::size_t k) { return state(k).pressure; });
  states.damage = in_lanes([&](std::size_t k) { return state(k).damage; });
  advance_deviator(model, gradient, WidePack(0.0), WidePack(test::reference_density), dt, states);
  return states;
}

}  // namespace

TEST_CASE("Strengths: no step leaves the stress above the flow stress", "[strength]") {
  for_each_strength([](const auto& model, auto d) {
    using Model = std::decay_t<decltype(model)>;
    if constexpr (Model::kind.yields)
      walk<d>(model, [&](const auto& before, const auto&, const auto& after) {
        const double increment = after.plastic_strain - before.plastic_strain;
        const double flow = model.flow_stress({after.plastic_strain, increment / dt, before.temperature});
        REQUIRE(von_mises(after.stress) <=
                flow + 1e-9 * model.shear_modulus);  // the root is good to 1e-12 of a trial of G
      });
  });
}

TEST_CASE("Strengths: what flows plastically lies on the yield surface", "[strength]") {
  for_each_strength([](const auto& model, auto d) {
    using Model = std::decay_t<decltype(model)>;
    if constexpr (Model::kind.yields) {
      int flowing = 0;
      walk<d>(model, [&](const auto& before, const auto& l, const auto& after) {
        if (after.plastic_strain == before.plastic_strain) return;
        ++flowing;
        const auto trial =
            rotated(before.stress, l, dt) + (2.0 * model.shear_modulus * dt) * deviator(symmetric_part(l));
        const FlowState flow{before.plastic_strain, 0.0, before.temperature};
        const double increment = plastic_increment(model, von_mises(trial), model.flow_stress(flow), flow, dt);
        REQUIRE(after.plastic_strain == Approx(before.plastic_strain + increment).epsilon(1e-14));
        const double strength = model.flow_stress({flow.plastic_strain + increment, increment / dt, flow.temperature});
        const double left = von_mises(trial) - 3.0 * model.shear_modulus * increment - strength;
        REQUIRE(std::abs(left) <= 2e-12 * von_mises(trial));  // it is searched to half of that
      });
      CHECK(flowing > 100);
    }
  });
}

TEST_CASE("Strengths: particles side by side come to what each comes to alone", "[strength]") {
  for_each_strength([](const auto& model, auto d) {
    test::Random random(7);
    for (int repeat = 0; repeat < 200; ++repeat) {
      Tensor<double, d> l[width];
      DeviatorState<d> state[width];
      for (std::size_t k = 0; k < width; ++k) {  // some are at rest, some turn or strain a little, some flow
        l[k] = random.gradient<d>(k % 3 == 0 ? 0.0 : random.magnitude(1e-5, 1.0) / dt);
        state[k] = {random.symmetric<d>(1e-3 * model.shear_modulus),
                    random.between(0.0, 1.0),
                    0.0,
                    random.between(280.0, 2000.0),
                    random.between(-1e9, 1e10),
                    double(k % 2)};
      }
      const auto together = advanced<d>(
          model, [&](std::size_t k) { return l[k]; }, [&](std::size_t k) { return state[k]; });
      const auto last = advanced<d>(
          model, [&](std::size_t) { return l[width - 1]; }, [&](std::size_t) { return state[width - 1]; });
      for (int c = 0; c < together.stress.size; ++c)
        REQUIRE(double(together.stress.c[c][width - 1]) == double(last.stress.c[c][0]));
      REQUIRE(double(together.plastic_strain[width - 1]) == double(last.plastic_strain[0]));
      for (std::size_t k = 0; k < width; ++k) {
        advance_deviator(model, l[k], 0.0, test::reference_density, dt, state[k]);
        for (int c = 0; c < together.stress.size; ++c)
          REQUIRE(together.stress.c[c][k] == Approx(state[k].stress.c[c]).margin(1e-11 * (model.shear_modulus + 1.0)));
        REQUIRE(together.plastic_strain[k] == Approx(state[k].plastic_strain).epsilon(1e-11));
        REQUIRE(
            together.plastic_work[k] ==
            Approx(state[k].plastic_work).epsilon(1e-9).margin(1e-11 * model.shear_modulus / test::reference_density));
        REQUIRE(together.temperature[k] == Approx(state[k].temperature).epsilon(1e-9));
      }
    }
  });
}

TEST_CASE("Strengths: flow and slope along a step are those of the flow stress", "[strength]") {
  for_each_sample<Strength>([](const auto& model) {
    using Model = std::decay_t<decltype(model)>;
    if constexpr (Model::kind.hardens) {
      test::Random random(5);
      for (int repeat = 0; repeat < 200; ++repeat) {
        const FlowState before{random.between(0.0, 0.5), 0.0, random.between(280.0, 700.0), random.between(-1e9, 1e10),
                               random.between(0.0, 1.0)};
        const auto after = [&](double increment) {
          return FlowState{before.plastic_strain + increment, increment / dt, before.temperature, before.pressure,
                           before.damage};
        };
        const double increment = random.magnitude(1e-6, 0.1), change = 1e-5 * increment;
        const double difference =
            model.flow_stress(after(increment + change)) - model.flow_stress(after(increment - change));
        const Flow flow = model.flow_in(dt, before)(increment);
        REQUIRE(flow.stress == Approx(model.flow_stress(after(increment))).epsilon(1e-14));
        REQUIRE(flow.slope == Approx(difference / (2.0 * change)).epsilon(1e-5).margin(1e-6 * model.shear_modulus));
      }
    }
  });
}

TEST_CASE("Strengths: plastic strain and work never fall, and the work is stress times strain", "[strength]") {
  for_each_strength([](const auto& model, auto d) {
    walk<d>(model, [&](const auto& before, const auto&, const auto& after) {
      const double increment = after.plastic_strain - before.plastic_strain;
      const double work = after.plastic_work - before.plastic_work;
      REQUIRE(increment >= 0.0);
      REQUIRE(work >= 0.0);
      const double expected = von_mises(after.stress) * increment / test::reference_density;
      REQUIRE(work == Approx(expected).epsilon(1e-6).margin(1e-12 * after.plastic_work));  // a difference of sums
    });
  });
}

TEST_CASE("Strengths: the stress stays a deviator", "[strength]") {
  for_each_strength([](const auto& model, auto d) {
    walk<d>(model, [&](const auto&, const auto&, const auto& after) {
      REQUIRE(std::abs(trace(after.stress)) <= 1e-12 * (model.shear_modulus + von_mises(after.stress)));
    });
  });
}

TEST_CASE("Strengths: below the flow stress, straining back brings the stress back", "[strength]") {
  for_each_strength([](const auto& model, auto d) {
    using Model = std::decay_t<decltype(model)>;
    test::Random random(d);
    for (int repeat = 0; repeat < 100; ++repeat) {
      auto state = test::start_of<d>(model);
      const auto stretch =
          test::without_spin(random.gradient<d>(1e-4 / dt));  // 1e-4 stays below every flow stress here
      advance_deviator(model, stretch, 0.0, test::reference_density, dt, state);
      if constexpr (Model::kind.shears) {
        const auto elastic = (2.0 * model.shear_modulus * dt) * deviator(symmetric_part(stretch));
        REQUIRE(von_mises(state.stress - elastic) <= 1e-15 * model.shear_modulus);
      }
      advance_deviator(model, test::negative(stretch), 0.0, test::reference_density, dt, state);
      REQUIRE(von_mises(state.stress) <= 1e-15 * model.shear_modulus);
      REQUIRE(state.plastic_strain == 0.0);
    }
  });
}

TEST_CASE("Strengths: in uniaxial strain the deviator ends at two thirds of the flow stress", "[strength]") {
  const PerfectlyPlastic model{27.6e9, 0.3e9};
  auto state = test::start_of<1>(model);
  const Tensor<double, 1> compression{{-1e-3 / dt}};
  // Elastic up to Y/(2G) = 0.00543: five steps of 1e-3.
  for (int step = 1; step <= 5; ++step) {
    advance_deviator(model, compression, 0.0, 2785.0, dt, state);
    CHECK(state.stress.c[0] == Approx(-4.0 / 3.0 * 27.6e9 * 1e-3 * step).epsilon(1e-14));
  }
  advance_deviator(model, compression, 0.0, 2785.0, dt, state);
  CHECK(state.stress.c[0] == Approx(-0.2e9).epsilon(1e-14));
  CHECK(state.plastic_strain == Approx(2.0 / 3.0 * (6e-3 - 0.3e9 / (2.0 * 27.6e9))).epsilon(1e-12));
}

TEST_CASE("Strengths: a fluid carries no shear", "[strength]") {
  test::Random random(3);
  auto state = test::start_of<3>(NoStrength{});
  advance_deviator(NoStrength{}, random.gradient<3>(1.0 / dt), 0.0, 1000.0, dt, state);
  CHECK(von_mises(state.stress) == 0.0);
}
