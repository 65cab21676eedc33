// A plate at 602.81 m/s on one at rest: an elastic precursor and a plastic shock on either side. Connolly and
// Iannucci's time-split Godunov paper, section 4.1, with its isothermal equation of state; the exact states follow from
// the jump conditions.
#include <catch2/catch.hpp>

#include "support/lattice.hpp"

using namespace tektite;

namespace {

constexpr double density = 6100.0, closing_speed = 602.81, end = 0.5e-6;
constexpr double c0_squared = 5077.0 * 5077.0, slope = 1.201, shear = 48.1e9, flow_stress = 2.5e9;

struct Plateau {
  double density, stress, velocity;  ///< kg/m³, Pa (compression positive), m/s relative to what lies ahead
};

/// The exact states for this material at rest: the precursor and what the plastic shock leaves.
constexpr Plateau precursor{6260.6, 5.8283e9, 156.56}, shocked{6440.3, 10.5368e9, 301.405};
constexpr double precursor_speed = 6103.0, shock_speed = 5348.76;  // m/s, into the material at rest

/// Means of a run over the particles whose distance into the plate at rest, in its initial state, is in a range.
Plateau mean_over(const Simulation& simulation, const std::vector<double>& start, double from, double to) {
  const auto rho = test::by_id(simulation.particles(), Field::density);
  const auto p = test::by_id(simulation.particles(), Field::pressure);
  const auto s = test::by_id(simulation.particles(), Field::deviatoric_stress);
  const auto v = test::by_id(simulation.particles(), Field::velocity);
  Plateau mean{0.0, 0.0, 0.0};
  double count = 0.0;
  for (std::size_t i = 0; i < rho.size(); ++i) {
    if (start[i] < from || start[i] > to) continue;
    mean.density += rho[i];
    mean.stress += p[i] - s[3 * i];
    mean.velocity += v[i];
    ++count;
  }
  return {mean.density / count, mean.stress / count, mean.velocity / count};
}

/// Where the velocity last exceeds a value, as a distance into the plate at rest in its initial state.
double front(const Simulation& simulation, const std::vector<double>& start, double velocity) {
  const auto v = test::by_id(simulation.particles(), Field::velocity);
  double farthest = 0.0;
  for (std::size_t i = 0; i + 1 < v.size(); ++i)
    if (v[i] >= velocity && v[i + 1] < velocity)
      farthest = start[i] + (start[i + 1] - start[i]) * (v[i] - velocity) / (v[i] - v[i + 1]);
  return farthest;
}

}  // namespace

TEST_CASE("Flyer plate: the exact states satisfy the jump conditions and the yield condition", "[flyer]") {
  // The figures above to their printed digits, from ρ0 U = ρ (U - v), σ - σ_ahead = ρ_ahead (U - v_ahead)(v - v_ahead).
  CHECK(precursor.velocity == Approx(precursor_speed * (1.0 - density / precursor.density)).epsilon(1e-3));
  CHECK(precursor.stress == Approx(density * precursor_speed * precursor.velocity).epsilon(1e-3));
  CHECK(shocked.stress - precursor.stress ==
        Approx(density * (shock_speed - 0.0) * (shocked.velocity - precursor.velocity) *
               (1.0 - precursor.velocity / shock_speed) * precursor.density / density)
            .epsilon(2e-3));
  const double zeta = shocked.density / density - 1.0;
  const double pressure = density * c0_squared * zeta / (1.0 - (slope - 1.0) * zeta);
  CHECK(shocked.stress == Approx(pressure + 2.0 / 3.0 * flow_stress).epsilon(1e-3));
  CHECK(std::log(precursor.density / density) == Approx(flow_stress / (2.0 * shear)).epsilon(1e-3));
}

TEST_CASE("Flyer plate: precursor and plastic shock have the exact speeds and states", "[flyer]") {
  constexpr int half = 800;
  constexpr double spacing = 0.005 / half;
  constexpr double ratio = 2.0;  // where the cubic spline's sums over a line are exact, at rest
  auto particles = test::particles_on(
      Space::line,
      {{"flyer", "metal", spacing, {-0.005 + 0.5 * spacing}, {half}, {closing_speed}, nullptr, ratio},
       {"plate", "metal", spacing, {0.5 * spacing}, {half}, {0.0}, nullptr, ratio}},
      density);
  const auto start = test::by_id(particles, Field::position);
  auto simulation = test::simulation_of(
      "time.end = '0.5 us'\n[material.metal]\ndensity = 6100.0\n"
      "eos = { model = 'mie-grueneisen-isothermal', bulk_sound_speed = 5077.0, hugoniot_slope = 1.201 }\n"
      "strength = { model = 'perfectly-plastic', shear_modulus = '48.1 GPa', yield_stress = '2.5 GPa' }\n",
      std::move(particles));
  const double half_precursor = 0.5 * precursor.velocity, half_shock = 0.5 * (precursor.velocity + shocked.velocity);
  while (simulation.time() < 0.3 * end) simulation.step();
  const double time = simulation.time();
  const double precursor_then = front(simulation, start, half_precursor);
  const double shock_then = front(simulation, start, half_shock);
  test::run_to_the_end(simulation);

  // Between two times, so that what the fronts lose or gain while they form does not count; in initial places the
  // shock's speed is ρ (U - v)/ρ0.
  const double precursor_found = (front(simulation, start, half_precursor) - precursor_then) / (end - time);
  const double shock_found = (front(simulation, start, half_shock) - shock_then) / (end - time);
  const double shock_exact = precursor.density / density * (shock_speed - precursor.velocity);
  WARN("precursor " << precursor_found << " m/s, exact " << precursor_speed << "; shock " << shock_found
                    << " m/s, exact " << shock_exact);
  CHECK(precursor_found == Approx(precursor_speed).epsilon(0.01));
  CHECK(shock_found == Approx(shock_exact).epsilon(0.01));

  const double between = 0.5 * (precursor_speed + shock_exact) * end;
  const auto ahead = mean_over(simulation, start, between - 4.0 * spacing, between + 4.0 * spacing);
  const auto behind = mean_over(simulation, start, 0.2 * shock_exact * end, 0.8 * shock_exact * end);
  WARN("precursor: " << ahead.density << " kg/m3, " << ahead.stress << " Pa, " << ahead.velocity << " m/s; shocked: "
                     << behind.density << " kg/m3, " << behind.stress << " Pa, " << behind.velocity << " m/s");
  // The precursor's plateau is little longer than the two fronts are wide.
  CHECK(ahead.density - density == Approx(precursor.density - density).epsilon(0.01));
  CHECK(ahead.stress == Approx(precursor.stress).epsilon(0.01));
  CHECK(ahead.velocity == Approx(precursor.velocity).epsilon(0.01));
  CHECK(behind.density - density == Approx(shocked.density - density).epsilon(0.005));
  CHECK(behind.stress == Approx(shocked.stress).epsilon(0.005));
  CHECK(behind.velocity == Approx(shocked.velocity).epsilon(0.005));
  CHECK(std::abs(simulation.momentum_drift(simulation.ledger())) < 1e-12);
}
