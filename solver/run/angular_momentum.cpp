#include "run/angular_momentum.hpp"

#include <Eigen/Dense>

#include "core/space.hpp"

namespace tektite {
namespace {

/// A particle's vector in the space solid; components that it has not are zero.
Eigen::Vector3d vector_of(std::span<const double> field, std::size_t particle, int dimensions) {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  for (int k = 0; k < dimensions; ++k) v[k] = field[particle * static_cast<std::size_t>(dimensions) + k];
  return v;
}

}  // namespace

std::vector<int> axes_of_turning(Space space) {
  switch (space) {
    case Space::solid:
      return {0, 1, 2};
    case Space::plane_strain:
    case Space::plane_stress:
      return {2};
    default:
      return {};
  }
}

AngularMomentum angular_momentum_of(const Particles& particles) {
  const auto axes = axes_of_turning(particles.space());
  if (axes.empty()) return {};
  const int dimensions = particles.dimensions();
  const auto mass = particles.reals(Field::mass), position = particles.reals(Field::position),
             velocity = particles.reals(Field::velocity);
  double whole = 0.0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(), mean = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < particles.count(); ++i) {
    whole += mass[i];
    centre += mass[i] * vector_of(position, i, dimensions);
    mean += mass[i] * vector_of(velocity, i, dimensions);
  }
  centre /= whole;
  mean /= whole;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  AngularMomentum result;
  for (std::size_t i = 0; i < particles.count(); ++i) {
    const Eigen::Vector3d arm = vector_of(position, i, dimensions) - centre;
    const Eigen::Vector3d momentum = mass[i] * (vector_of(velocity, i, dimensions) - mean);
    sum += arm.cross(momentum);
    result.largest += arm.norm() * momentum.norm();
  }
  for (const int axis : axes) result.components.push_back(sum[axis]);
  return result;
}

}  // namespace tektite
