// A plate of steel strikes one of aluminium: both meet at the pressure and the speed at which the Hugoniots of the two
// cross, whatever the jump of density between them.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "physics/hugoniot.hpp"
#include "support/lattice.hpp"

using namespace tektite;

namespace {

constexpr double speed = 1500.0;  // m/s
constexpr double spacing = 5e-5;  // m
constexpr int flying = 100, resting = 200;

constexpr MieGrueneisen steel{7850.0, 4570.0, 1.49, 2.0};
constexpr MieGrueneisen aluminium{2785.0, 5328.0, 1.338, 2.0};

/// Of a body's particles between two places, 0.3 to 0.6 mm behind the contact: behind the shock, ahead of any relief.
double mean_of(const Particles& particles, Field field, std::size_t body, double contact) {
  const auto& range = particles.bodies()[body].range;
  double sum = 0.0, count = 0.0;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const double away = std::abs(particles.reals(Field::position)[i] - contact);
    if (away < 3e-4 || away > 6e-4) continue;
    sum += particles.reals(field)[i];
    count += 1.0;
  }
  REQUIRE(count > 3.0);
  return sum / count;
}

}  // namespace

TEST_CASE("Unlike plates: pressure, speed and both densities are those of the crossing Hugoniots", "[shock]") {
  const auto exact = match_impedances(steel, aluminium, speed).value();
  const double met = exact.second.pressure / (aluminium.reference_density * exact.second.shock_speed);  // m/s
  for (const std::string scheme :
       {"type = 'eulerian'", "type = 'total-lagrangian'", "type = 'eulerian' }\nviscosity = { model = 'limited'",
        "type = 'total-lagrangian' }\nviscosity = { model = 'limited'", "type = 'godunov-split', order = 1",
        "type = 'godunov-split', order = 2", "type = 'godunov-pm'", "type = 'msph', smoothing_share = 0.2"}) {
    INFO(scheme);
    const bool lagrangian = scheme.find("total") != std::string::npos, msph = scheme.find("msph") != std::string::npos;
    auto particles = test::particles_on(
        Space::line,
        {{"flyer", "steel", spacing, {(0.5 - flying) * spacing}, {flying}, {speed}, nullptr, msph ? 1.5 : 1.2},
         {"target", "aluminium", spacing, {0.5 * spacing}, {resting}, {0.0}, nullptr, msph ? 1.5 : 1.2}},
        steel.reference_density);
    for (std::size_t i = flying; i < flying + resting; ++i) {
      particles.scalars(Field::mass)[i] *= aluminium.reference_density / steel.reference_density;
      particles.scalars(Field::density)[i] = aluminium.reference_density;
    }
    auto run = test::simulation_of(
        "scheme = { " + scheme + " }\ntime.end = '0.4 us'\n" +
            (lagrangian ? "contact.model = 'kernel-penalty'\n" : "") +
            (msph ? "smoothing.kernel = 'truncated-gaussian'\n" : "") +
            "[material.steel]\ndensity = 7850.0\n"
            "eos = { model = 'mie-grueneisen', bulk_sound_speed = 4570.0, hugoniot_slope = 1.49, grueneisen = 2.0 }\n"
            "[material.aluminium]\ndensity = 2785.0\n"
            "eos = { model = 'mie-grueneisen', bulk_sound_speed = 5328.0, hugoniot_slope = 1.338, grueneisen = 2.0 }\n",
        std::move(particles));
    const double before = run.ledger().total();
    while (!run.finished()) run.step();
    CHECK(run.ledger().total() == Approx(before).epsilon(2e-3));
    const auto& after = run.particles();
    const double contact = met * run.time();
    for (const std::size_t body : {0u, 1u}) {
      INFO("body " << body);
      const auto& state = body == 0 ? exact.first : exact.second;
      CHECK(mean_of(after, Field::pressure, body, contact) == Approx(state.pressure).epsilon(0.02));
      CHECK(mean_of(after, Field::velocity, body, contact) == Approx(met).epsilon(0.01));
      CHECK(mean_of(after, Field::density, body, contact) == Approx(state.density).epsilon(0.01));
    }
  }
}
