// Plane stress with every pair of equation of state and strength.
#include "physics/strength/plane_stress.hpp"

#include <catch2/catch.hpp>

#include "physics/strength/strength.hpp"
#include "support/models.hpp"
#include "support/random_step.hpp"

using namespace tektite;
using test::for_each_sample;

namespace {

constexpr double dt = 1e-8;  // s

struct Element {
  DeviatorState<2> state;
  double density = test::reference_density;
  double thickness = 1.0;
};

/// A step of an element under L, with the stretch across that plane stress asks for.
template <class EosModel, class StrengthModel>
void step(const EosModel& eos, const StrengthModel& strength, const Tensor<double, 2>& l, double energy,
          Element& element) {
  const double across = plane_stress_rate(eos, strength, l, element.density, energy, 0.0, dt, element.state);
  advance_deviator(strength, l, across, element.density, dt, element.state);
  element.density *= std::exp(-dt * (trace(l) + across));
  element.thickness *= std::exp(dt * across);
}

template <class EosModel>
double stress_across(const EosModel& eos, double energy, const Element& element) {
  return element.state.stress.c[2] - eos.pressure(element.density, energy);
}

}  // namespace

TEST_CASE("Plane stress: the stress across the plane stays at zero in any step", "[plane_stress]") {
  for_each_sample<Eos>([](const auto& eos) {
    if constexpr (std::is_same_v<std::decay_t<decltype(eos)>, IdealGas>) return;  // is nowhere without pressure
    for_each_sample<Strength>([&](const auto& strength) {
      test::Random random(1);
      Element element{test::start_of<2>(strength)};
      double energy = 0.0, worst = 0.0;
      for (int k = 0; k < 300; ++k) {
        step(eos, strength, random.gradient<2>(random.magnitude(1e-5, 0.05) / dt), energy, element);
        worst = std::max(worst, std::abs(stress_across(eos, energy, element)));
        energy += 10.0;
      }
      const double bulk = test::reference_density * eos.pressure_by_density(test::reference_density, 0.0);
      // What the rate is searched to is 1e-10 of the stiffness, which compression raises.
      CHECK(worst <= 2e-10 * (bulk + 4.0 / 3.0 * strength.shear_modulus));
      CHECK(element.density * element.thickness > 0.0);
    });
  });
}

TEST_CASE("Plane stress: a small strain meets the stiffness of a thin plate", "[plane_stress]") {
  const double bulk = 79e9, shear = 27.6e9;
  const LinearEos eos{2785.0, bulk};
  const Elastic strength{shear};
  Element element{test::start_of<2>(strength)};
  const double strain = 1e-6;
  step(eos, strength, {{strain / dt, 0.0, 0.0, 0.0}}, 0.0, element);
  // σ_xx = E/(1 - ν²) ε, σ_yy = ν σ_xx, ε_zz = -ν/(1 - ν) ε
  const double young = 9.0 * bulk * shear / (3.0 * bulk + shear);
  const double nu = young / (2.0 * shear) - 1.0;
  const double pressure = eos.pressure(element.density, 0.0);
  // To the strain itself: density is exponential in it.
  CHECK(element.state.stress.c[0] - pressure == Approx(young / (1.0 - nu * nu) * strain).epsilon(3.0 * strain));
  CHECK(element.state.stress.c[1] - pressure == Approx(nu * young / (1.0 - nu * nu) * strain).epsilon(5.0 * strain));
  CHECK(std::log(element.thickness) == Approx(-nu / (1.0 - nu) * strain).epsilon(5.0 * strain));
}
