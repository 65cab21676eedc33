// Noh's problem by msph, planar and cylindrical, against the exact solution (postprocess/measure/noh.cpp states it).
#include <catch2/catch.hpp>

#include "support/lattice.hpp"

using namespace tektite;

namespace {

struct Profile {
  double shock, density, energy, velocity;  ///< means of the last three over 0.06 < R < 0.15, behind the shock
};

Profile noh(Space space, int count) {
  const double spacing = 1.0 / count;
  auto p = test::particles_on(space, {{"gas", "gas", spacing, {0.5 * spacing}, {count}, {-1.0}, nullptr, 1.5}}, 1.0);
  const int hoops = hoops_of(space);
  for (std::size_t i = 0; i < p.count(); ++i) p.scalars(Field::mass)[i] *= std::pow(p.reals(Field::position)[i], hoops);
  const std::string wall = hoops == 0 ? "symmetry.wall = { axis = 'x' }\n" : "";
  auto simulation = test::simulation_of(wall +
                                            "scheme.type = 'msph'\nsmoothing = { kernel = 'truncated-gaussian', ratio "
                                            "= 1.5 }\ntime.end = 0.6\n[material.gas]\ndensity = 1.0\n"
                                            "eos = { model = 'ideal-gas', heat_ratio = 1.6666666666666667 }\n",
                                        std::move(p));
  test::run_to_the_end(simulation);
  const auto x = test::by_id(simulation.particles(), Field::position);
  const auto rho = test::by_id(simulation.particles(), Field::density);
  const auto e = test::by_id(simulation.particles(), Field::specific_internal_energy);
  const auto v = test::by_id(simulation.particles(), Field::velocity);
  Profile found{0.0, 0.0, 0.0, 0.0};
  double behind = 0.0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (v[i - 1] > -0.5 && v[i] <= -0.5) found.shock = x[i];
    if (x[i] < 0.06 || x[i] > 0.15) continue;
    found.density += rho[i];
    found.energy += e[i];
    found.velocity += v[i];
    ++behind;
  }
  found.density /= behind;
  found.energy /= behind;
  found.velocity /= behind;
  return found;
}

}  // namespace

TEST_CASE("Noh: shock and states behind it", "[msph][noh]") {
  for (const auto space : {Space::line, Space::cylindrical}) {
    const auto found = noh(space, 400);
    const double exact = std::pow(4.0, 1 + hoops_of(space));
    WARN(name_of(space) << ": shock at " << found.shock << " (0.2), density " << found.density << " (" << exact
                        << "), energy " << found.energy << " (0.5), velocity " << found.velocity << " (0)");
    // The strong form does not keep momentum at the jump: examples/noh/README.md tells the same of 800 particles.
    CHECK(found.shock == Approx(0.2).epsilon(0.15));
    CHECK(found.energy == Approx(0.5).epsilon(0.05));
    CHECK(std::abs(found.velocity) < 0.01);
  }
}
