// A rigid rotation turns the stress and does nothing else, however large the step.
#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "physics/strength/strength.hpp"
#include "support/models.hpp"
#include "support/random_step.hpp"

using namespace tektite;

namespace {

template <int D>
Eigen::Matrix3d full(const Symmetric<double, D>& s) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) m(i, i) = s(i, i);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) m(i, j) = s(i, j);
  return m;
}

/// The velocity gradient in the middle of a step dt that turns about `axis` by `angle`. Material points keep their
/// distances where the chord over dt is the velocity of the middle: |ω| dt = 2 tan(angle/2) (Hughes and Winget 1980).
template <int D>
Tensor<double, D> spin(const Eigen::Vector3d& axis, double angle, double dt) {
  const Eigen::Vector3d omega = 2.0 * std::tan(0.5 * angle) / dt * axis.normalized();
  Eigen::Matrix3d w;
  w << 0.0, -omega.z(), omega.y(), omega.z(), 0.0, -omega.x(), -omega.y(), omega.x(), 0.0;
  Tensor<double, D> l;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) l(i, j) = w(i, j);
  return l;
}

template <int D>
Eigen::Vector3d random_axis(test::Random& random) {
  if constexpr (D == 2) return Eigen::Vector3d(0.0, 0.0, random.between(0.0, 1.0) < 0.5 ? -1.0 : 1.0);
  return Eigen::Vector3d(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0));
}

template <int D>
void check_turned() {
  test::Random random(D);
  for (const double angle : {1e-6, 0.01, 0.5, 1.5, 3.0}) {
    const auto s = deviator(random.symmetric<D>(1e8));
    const auto axis = random_axis<D>(random);
    const Eigen::Matrix3d r = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
    const Eigen::Matrix3d expected = r * full(s) * r.transpose();
    CAPTURE(D, angle);
    // Rounding; tan(angle/2) near 180° loses a digit.
    CHECK((full(rotated(s, spin<D>(axis, angle, 1e-8), 1e-8)) - expected).norm() <= 1e-13 * full(s).norm());
  }
}

template <int D>
void check_invariants() {
  test::for_each_sample<Strength>([](const auto& model) {
    using Model = std::decay_t<decltype(model)>;
    if constexpr (Model::kind.shears) {
      test::Random random(D);
      auto state = test::start_of<D>(model);
      state.stress = deviator(random.symmetric<D>(1e7));
      const Eigen::Matrix3d start = full(state.stress);
      for (int step = 0; step < 1000; ++step)
        advance_deviator(model, spin<D>(random_axis<D>(random), random.between(-3.0, 3.0), 1e-8), 0.0, 2785.0, 1e-8,
                         state);
      const Eigen::Matrix3d end = full(state.stress);
      // 1000 roundings; a strain rate that tan(angle/2) leaves in L is below one of them.
      CHECK(end.norm() == Approx(start.norm()).epsilon(1e-12));
      CHECK(end.determinant() == Approx(start.determinant()).epsilon(1e-12).margin(1e-12 * std::pow(start.norm(), 3)));
      CHECK(state.plastic_strain == 0.0);
    }
  });
}

}  // namespace

TEST_CASE("Rotation: the stress turns with the material exactly", "[rotation]") {
  check_turned<2>();
  check_turned<3>();
}

TEST_CASE("Rotation: the stress keeps its invariants through a thousand large turns", "[rotation]") {
  check_invariants<2>();
  check_invariants<3>();
}

TEST_CASE("Rotation: a turn in a plane is the same in two dimensions and in three", "[rotation]") {
  test::Random random(5);
  const auto plane = deviator(random.symmetric<2>(1e8));
  auto solid = Symmetric<double, 3>::zero();
  for (int k = 0; k < 4; ++k) solid.c[k] = plane.c[k];
  const Eigen::Vector3d z(0.0, 0.0, 1.0);
  const auto turned_plane = rotated(plane, spin<2>(z, 0.7, 1.0), 1.0);
  const auto turned_solid = rotated(solid, spin<3>(z, 0.7, 1.0), 1.0);
  CHECK((full(turned_plane) - full(turned_solid)).norm() <= 1e-15 * full(plane).norm());
}
