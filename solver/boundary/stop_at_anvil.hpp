#pragma once

#include <cstdint>
#include <vector>

#include "boundary/anvil.hpp"
#include "core/particles.hpp"
#include "parallel/for_each.hpp"

namespace tektite {

/// The anvil of schemes whose sums are forces: a particle at the wall that these would bring into it is stopped, one
/// that they draw away leaves. A wall at rest does no work, so what stopping takes from the kinetic energy heats.
template <int D>
class StopAtAnvil {
 public:
  explicit StopAtAnvil(const std::optional<SymmetryPlane>& plane) : plane_(plane), anvil_(plane) {}

  /// Between the forces and the end of a step: the accelerations that stop.
  void stop(Particles& p, double dt) {
    if (!plane_) return;
    const int n = plane_->axis;
    const double side = plane_->side;
    held_.resize(p.count());
    const auto *x = p.template vectors<D>(Field::position), *v = p.template vectors<D>(Field::velocity);
    auto* a = p.template vectors<D>(Field::acceleration);
    double* energy = p.scalars(Field::specific_internal_energy);
    for_each(p.count(), [&](std::size_t i) {
      const double speed = v[i][n], pull = a[i][n];
      held_[i] = anvil_.touches(x[i]) && side * speed <= 0.0 && side * (speed + dt * pull) <= 0.0;
      if (!held_[i]) return;
      a[i][n] = -speed / dt;
      energy[i] += 0.5 * speed * (speed + dt * pull);
    });
  }

  /// At the end of a step: who was stopped stands at the wall.
  void rest(Particles& p) const {
    if (!plane_) return;
    const int n = plane_->axis;
    for_each(p.count(), [&](std::size_t i) {
      if (!held_[i]) return;
      p.template vectors<D>(Field::velocity)[i][n] = p.template vectors<D>(Field::acceleration)[i][n] = 0.0;
      p.template vectors<D>(Field::position)[i][n] = plane_->at;
    });
  }

 private:
  std::optional<SymmetryPlane> plane_;
  Anvil<D> anvil_;
  std::vector<std::uint8_t> held_;
};

}  // namespace tektite
