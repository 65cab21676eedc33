// The answer does not depend on who looks: a moving observer, a mirror, a turned head. To round-off only, because
// coordinates round differently and neighbours are added up in another order.
#include <catch2/catch.hpp>

#include "support/impact.hpp"

using namespace tektite;

namespace {

constexpr int steps = 100;

/// 1e-16 in the first step, and below 1e-12 after a hundred; ten times that for other processors.
constexpr double rounding = 1e-11;

/// Axis k of the new frame is axis[k] of the old one, times sign[k].
struct Turn {
  int axis[3];
  double sign[3];
};

template <int D>
Vector<double, D> turned(const Turn& turn, const Vector<double, D>& x) {
  Vector<double, D> y;
  for (int k = 0; k < D; ++k) y[k] = turn.sign[k] * x[turn.axis[k]];
  return y;
}

template <int D>
Symmetric<double, D> turned(const Turn& turn, const Symmetric<double, D>& s) {
  auto t = s;
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j) t(i, j) = turn.sign[i] * turn.sign[j] * s(turn.axis[i], turn.axis[j]);
  return t;
}

/// Largest difference of two fields in any component, over `scale`.
double difference(const std::vector<double>& a, const std::vector<double>& b, double scale) {
  REQUIRE(a.size() == b.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = std::abs(a[i] - b[i]);
    largest = d > largest || std::isnan(d) ? d : largest;
  }
  return largest / scale;
}

template <int D>
std::vector<double> turned_vectors(const Turn& turn, std::vector<double> values) {
  auto* v = reinterpret_cast<Vector<double, D>*>(values.data());
  for (std::size_t i = 0; i < values.size() / D; ++i) v[i] = turned<D>(turn, v[i]);
  return values;
}

template <int D>
std::vector<double> turned_stress(const Turn& turn, std::vector<double> values) {
  auto* s = reinterpret_cast<Symmetric<double, D>*>(values.data());
  for (std::size_t i = 0; i < values.size() / Symmetric<double, D>::size; ++i) s[i] = turned<D>(turn, s[i]);
  return values;
}

template <Space space>
void check_turn(const Turn& turn) {
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

constexpr Turn mirror_x{{0, 1, 2}, {-1.0, 1.0, 1.0}};
constexpr Turn quarter_about_z{{1, 0, 2}, {-1.0, 1.0, 1.0}};
constexpr Turn cyclic{{1, 2, 0}, {1.0, 1.0, 1.0}};
constexpr Turn quarter_about_x{{0, 2, 1}, {1.0, -1.0, 1.0}};

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
