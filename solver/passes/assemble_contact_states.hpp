#pragma once

#include <cmath>

#include "passes/godunov_records.hpp"

namespace tektite {

/// What the contacts of Parshikov and Medin see of a particle.
template <int D>
struct AssembleContactStates {
  const Vector<double, D>* position;
  const Vector<double, D>* velocity;
  const Symmetric<double, D>* deviatoric_stress;
  const double* mass;
  const double* density;
  const double* pressure;
  const double* wave_speed;
  const double* smoothing_length;
  double shear_modulus;
  ContactStateRecord<D>* records;

  void operator()(std::size_t i) const {
    auto& r = records[i];
    r.x = position[i];
    r.v = velocity[i];
    for (int k = 0; k < D; ++k)
      for (int m = k; m < D; ++m) r.stress[r.index(k, m)] = deviatoric_stress[i](k, m) - (k == m ? pressure[i] : 0.0);
    r.volume = mass[i] / density[i];
    r.longitudinal = density[i] * wave_speed[i];
    r.transverse = std::sqrt(density[i] * shear_modulus);
    r.smoothing_length = smoothing_length[i];
  }
};

}  // namespace tektite
