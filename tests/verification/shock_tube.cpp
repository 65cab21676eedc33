// Sod's shock tube (1978), gas of γ = 1.4 with (ρ, p) = (1, 1) against (0.125, 0.1): shock, contact and rarefaction of
// every scheme that takes a gas, against the exact solution.
#include <catch2/catch.hpp>

#include "physics/eos/eos.hpp"
#include "support/lattice.hpp"
#include "support/riemann.hpp"

using namespace tektite;

namespace {

constexpr double end = 0.2;
const test::FluidState left{1.0, 0.0, 2.5, 0.0}, right{0.125, 0.0, 2.0, 0.0};  // ρ, v, e

struct Errors {
  double density, velocity, pressure;  ///< mean of |ours - exact| where the ends are not felt
  double drift;                        ///< of the total energy, relative
};

Errors sod(const std::string& scheme, double ratio, double spacing) {
  const int half = static_cast<int>(std::lround(1.0 / spacing));
  auto p = test::particles_on(Space::line,
                              {{"left", "gas", spacing, {-1.0 + 0.5 * spacing}, {half}, {0.0}, nullptr, ratio},
                               {"right", "gas", spacing, {0.5 * spacing}, {half}, {0.0}, nullptr, ratio}},
                              1.0);
  p.allocate(Field::specific_internal_energy);
  for (std::size_t i = 0; i < p.count(); ++i) {
    const auto& state = p.reals(Field::position)[i] < 0.0 ? left : right;
    p.reals(Field::density)[i] = state.density;
    p.reals(Field::mass)[i] = state.density * spacing;
    p.reals(Field::specific_internal_energy)[i] = state.energy;
  }
  auto simulation = test::simulation_of("time.end = 0.2\n" + scheme +
                                            "[material.gas]\ndensity = 1.0\n"
                                            "eos = { model = 'ideal-gas', heat_ratio = 1.4 }\n",
                                        std::move(p));
  const double before = simulation.ledger().total();
  test::run_to_the_end(simulation);
  const test::RiemannProblem exact(IdealGas{1.0, 1.4}, left, right);
  const auto& particles = simulation.particles();
  const auto x = particles.reals(Field::position), v = particles.reals(Field::velocity),
             rho = particles.reals(Field::density), pressure = particles.reals(Field::pressure);
  Errors errors{0.0, 0.0, 0.0, simulation.ledger().total() / before - 1.0};
  double count = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::abs(x[i]) > 0.45) continue;
    const auto state = exact.at(x[i] / end);
    errors.density += std::abs(rho[i] - state.density);
    errors.velocity += std::abs(v[i] - state.velocity);
    errors.pressure += std::abs(pressure[i] - state.pressure);
    ++count;
  }
  errors.density /= count;
  errors.velocity /= count;
  errors.pressure /= count;
  return errors;
}

}  // namespace

TEST_CASE("Shock tube: of a gas by eulerian and msph, nearer to the exact solution with a finer spacing",
          "[shock-tube]") {
  struct Case {
    std::string scheme;
    double ratio;
  };
  // h stays as it is at the start, and behind the rarefaction the spacing is 2.3 times as large: plain sums need twice
  // the usual h. The Godunov schemes are not here: their shock is 7 % too fast (solver/README.md).
  for (const Case& c :
       {Case{"scheme.type = 'eulerian'\n", 3.0}, Case{"viscosity.model = 'limited'\n", 3.0},
        Case{"scheme = { type = 'msph', forces = 'adjoint' }\nsmoothing.kernel = 'truncated-gaussian'\n", 1.5}}) {
    INFO(c.scheme);
    const auto coarse = sod(c.scheme, c.ratio, 0.01), fine = sod(c.scheme, c.ratio, 0.0025);
    constexpr double allowed = 0.025;  // of the left side's density, sound speed and pressure, which are about 1
    CHECK(fine.density < allowed);
    CHECK(fine.velocity < allowed);
    CHECK(fine.pressure < allowed);
    CHECK(fine.density < 0.6 * coarse.density);
    CHECK(fine.velocity < 0.6 * coarse.velocity);
    CHECK(fine.pressure < 0.6 * coarse.pressure);
    CHECK(std::abs(fine.drift) < 1e-3);
  }
}
