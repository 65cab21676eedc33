#pragma once

#include <memory>

#include "core/particles.hpp"

namespace tektite {

/// What the particles of a run are in the middle of a step, from the first one on: energy, pressure, sound speed,
/// deviatoric stress and velocity gradient. The passes over that run alone read it, so that it takes no field; but
/// where something else reads it too there are fields, and it is these.
template <int D>
class HalfState {
 public:
  HalfState(Particles& particles, const Range& range)
      : velocity_gradient(tensors(particles, range)),
        deviatoric_stress(symmetrics(particles, range)),
        energy(scalars(particles, range, Field::half_energy, 0)),
        pressure(scalars(particles, range, Field::half_pressure, 1)),
        sound_speed(scalars(particles, range, Field::half_sound_speed, 2)) {}

  /// Has fields take all but the velocity gradient.
  static void allocate(Particles& particles) {
    for (const auto field :
         {Field::half_energy, Field::half_pressure, Field::half_sound_speed, Field::half_deviatoric_stress})
      particles.allocate(field);
  }

 private:
  template <class T>
  using Room = std::unique_ptr<T[]>;
  Room<Tensor<double, D>> tensors_;
  Room<Symmetric<double, D>> symmetrics_;
  Room<double> scalars_[3];

  template <class T>
  static T* made(Room<T>& room, const Range& range) {
    room = std::make_unique_for_overwrite<T[]>(range.size());
    return room.get();
  }
  Tensor<double, D>* tensors(Particles& particles, const Range& range) {
    constexpr auto field = Field::velocity_gradient;
    return particles.has(field) ? particles.tensors<D>(field) + range.begin : made(tensors_, range);
  }
  Symmetric<double, D>* symmetrics(Particles& particles, const Range& range) {
    constexpr auto field = Field::half_deviatoric_stress;
    return particles.has(field) ? particles.symmetrics<D>(field) + range.begin : made(symmetrics_, range);
  }
  double* scalars(Particles& particles, const Range& range, Field field, std::size_t k) {
    return particles.has(field) ? particles.scalars(field) + range.begin : made(scalars_[k], range);
  }

 public:
  Tensor<double, D>* const velocity_gradient;
  Symmetric<double, D>* const deviatoric_stress;
  double* const energy;
  double* const pressure;
  double* const sound_speed;
};

}  // namespace tektite
