// The answer does not depend on who looks: a moving observer, a mirror, a turned head. To round-off only, because
// coordinates round differently and neighbours are added up in another order.
#include <catch2/catch.hpp>

#include "support/frames.hpp"
#include "support/impact.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

constexpr int steps = 100;

/// 1e-16 in the first step, and below 1e-12 after a hundred; ten times that for other processors.
constexpr double rounding = 1e-11;

template <Space space>
void check_turn(const Turn &turn) {
  constexpr int D = dimensions_of(space);
  INFO(name_of(space));
  auto particles = test::impact_particles(space);
  for (const auto field : {Field::position, Field::velocity})
    for (std::size_t i = 0; i < particles.count(); ++i)
      particles.vectors<D>(field)[i] = turned<D>(turn, particles.vectors<D>(field)[i]);
  auto straight = test::simulation_of(test::impact_scene, test::impact_particles(space));
  auto other = test::simulation_of(test::impact_scene, std::move(particles));
  test::take_steps(straight, steps);
  test::take_steps(other, steps);

  const auto &p = straight.particles(), &q = other.particles();
  const auto vectors_differ = [&](Field field, double scale) {
    return difference(turned_vectors<D>(turn, test::by_id(p, field)), test::by_id(q, field), scale);
  };
  CHECK(other.time() == Approx(straight.time()).epsilon(rounding));
  CHECK(vectors_differ(Field::position, test::impact_spacing) < rounding);
  CHECK(vectors_differ(Field::velocity, 1500.0) < rounding);
  CHECK(difference(test::by_id(p, Field::pressure), test::by_id(q, Field::pressure), 1e10) < rounding);
  CHECK(difference(test::by_id(p, Field::plastic_strain), test::by_id(q, Field::plastic_strain), 1.0) < rounding);
  CHECK(difference(turned_stress<D>(turn, test::by_id(p, Field::deviatoric_stress)),
                   test::by_id(q, Field::deviatoric_stress), 3e8) < rounding);
}

template <Space space>
void check_moving_observer() {
  constexpr int D = dimensions_of(space);
  INFO(name_of(space));
  Vector<double, D> drift;
  for (int k = 0; k < D; ++k) drift[k] = 700.0 - 900.0 * k;
  auto particles = test::impact_particles(space);
  for (std::size_t i = 0; i < particles.count(); ++i) particles.vectors<D>(Field::velocity)[i] += drift;
  auto rest = test::simulation_of(test::impact_scene, test::impact_particles(space));
  auto moving = test::simulation_of(test::impact_scene, std::move(particles));
  test::take_steps(rest, steps);
  test::take_steps(moving, steps);

  const auto &p = rest.particles(), &q = moving.particles();
  auto position = test::by_id(q, Field::position), velocity = test::by_id(q, Field::velocity);
  for (std::size_t n = 0; n < position.size(); ++n) {
    position[n] -= drift[static_cast<int>(n % D)] * moving.time();
    velocity[n] -= drift[static_cast<int>(n % D)];
  }
  CHECK(difference(test::by_id(p, Field::position), position, test::impact_spacing) < rounding);
  CHECK(difference(test::by_id(p, Field::velocity), velocity, 1500.0) < rounding);
  CHECK(difference(test::by_id(p, Field::pressure), test::by_id(q, Field::pressure), 1e10) < rounding);
  CHECK(difference(test::by_id(p, Field::deviatoric_stress), test::by_id(q, Field::deviatoric_stress), 3e8) < rounding);
}

}  // namespace

TEST_CASE("Frames: a moving observer sees the same", "[frames]") {
  check_moving_observer<Space::line>();
  check_moving_observer<Space::plane_strain>();
  check_moving_observer<Space::plane_stress>();
  check_moving_observer<Space::solid>();
}

TEST_CASE("Frames: the mirrored impact is the mirror image", "[frames]") {
  check_turn<Space::line>(mirror_x);
  check_turn<Space::plane_strain>(mirror_x);
  check_turn<Space::plane_stress>(mirror_x);
  check_turn<Space::solid>(mirror_x);
}

TEST_CASE("Frames: the impact turned by a right angle is the turned one", "[frames]") {
  check_turn<Space::plane_strain>(quarter_about_z);
  check_turn<Space::plane_stress>(quarter_about_z);
  check_turn<Space::solid>(quarter_about_z);
  check_turn<Space::solid>(quarter_about_x);
  check_turn<Space::solid>(cyclic);
}
