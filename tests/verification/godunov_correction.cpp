// The time-split Godunov scheme with the mixed correction: a linear velocity field on any arrangement, up to the
// boundary.
#include <catch2/catch.hpp>

#include "core/tensor_algebra.hpp"
#include "passes/across.hpp"
#include "support/lattice.hpp"
#include "support/random_step.hpp"

using namespace tektite;

namespace {

constexpr double spacing = 1e-3;

/// A block at rest without stress, disordered by a fifth of the spacing and with disordered masses, whose velocities
/// are L x.
template <int D>
Particles linear_motion(Space space, const Tensor<double, D>& l) {
  const int side = D == 3 ? 6 : 9;
  auto p = test::particles_on(space,
                              {{"block", "metal", spacing, std::vector<double>(D, 0.0), std::vector<int>(D, side),
                                std::vector<double>(D, 0.0)}},
                              2785.0);
  test::Random random(D);
  for (auto& x : p.reals(Field::position)) x += random.between(-0.2, 0.2) * spacing;
  for (auto& m : p.reals(Field::mass)) m *= random.between(0.8, 1.2);
  for (std::size_t i = 0; i < p.count(); ++i)
    p.vectors<D>(Field::velocity)[i] = times(l, p.vectors<D>(Field::position)[i]);
  return p;
}

template <int D>
void check_linear_motion(Space space, const std::string& scheme) {
  INFO(name_of(space) << " " << scheme);
  test::Random random(7);
  const auto l = random.gradient<D>(100.0);  // 1/s
  Simulation simulation =
      test::simulation_of("time.end = 1.0\nscheme = { type = 'godunov-split', correction = 'mixed', " + scheme +
                              " }\n[material.metal]\ndensity = 2785.0\n"
                              "eos = { model = 'linear', bulk_modulus = '79 GPa' }\n"
                              "strength = { model = 'elastic', shear_modulus = '27.6 GPa' }\n",
                          linear_motion(space, l));
  const Particles& p = simulation.particles();
  const auto gradients = p.reals(Field::velocity_gradient);
  for (std::size_t i = 0; i < gradients.size(); ++i) CHECK(gradients[i] == Approx(l.c[i % (D * D)]).margin(1e-9));
  simulation.step();
  const double expected = 2785.0 * density_factor(simulation.last_step().dt * trace(l));
  for (const double rho : p.reals(Field::density)) CHECK(rho == Approx(expected).epsilon(1e-14));
}

}  // namespace

TEST_CASE("Corrected Godunov sums: a linear velocity field has its gradient and its divergence", "[godunov]") {
  for (const std::string scheme : {"order = 1", "order = 2", "splitting = 'strang'"}) {
    check_linear_motion<1>(Space::line, scheme);
    check_linear_motion<2>(Space::plane_strain, scheme);
    check_linear_motion<3>(Space::solid, scheme);
  }
}
