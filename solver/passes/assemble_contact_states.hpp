#pragma once

#include <cmath>

#include "passes/godunov_records.hpp"
#include "passes/membrane.hpp"

namespace tektite {

/// What the contacts of Parshikov and Medin see of a particle; `damage` may be null where nothing fails, and
/// `thickness` and `membrane_density` stand for plane stress only.
template <int D, bool plane_stress>
struct AssembleContactStates {
  const Vector<double, D>* position;
  const Vector<double, D>* velocity;
  const Symmetric<double, D>* deviatoric_stress;
  const double* mass;
  const double* density;
  const double* pressure;
  const double* wave_speed;
  const double* smoothing_length;
  const double* damage;
  const double* thickness;
  double shear_modulus;
  double* membrane_density;  ///< ρ times the thickness
  ContactStateRecord<D>* records;

  void operator()(std::size_t i) const {
    auto& r = records[i];
    const double b = membrane<plane_stress>(thickness, i), area_density = b * density[i];
    if constexpr (plane_stress) membrane_density[i] = area_density;
    r.x = position[i];
    r.v = velocity[i];
    for (int k = 0; k < D; ++k)
      for (int m = k; m < D; ++m)
        r.stress[r.index(k, m)] = b * (deviatoric_stress[i](k, m) - (k == m ? pressure[i] : 0.0));
    r.volume = mass[i] / area_density;
    r.longitudinal = area_density * wave_speed[i];
    r.transverse = b * std::sqrt(density[i] * shear_modulus);
    r.smoothing_length = smoothing_length[i];
    r.failed = damage && damage[i] >= 1.0 ? 1.0 : 0.0;
  }
};

}  // namespace tektite
