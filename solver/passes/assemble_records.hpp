#pragma once

#include <cmath>

#include "core/tensor.hpp"
#include "passes/eulerian_record.hpp"

namespace tektite {

/// Puts together what a pair sees of a particle; place and velocity are in the record already. `thickness` is read
/// in plane stress only.
template <int D, bool plane_stress>
struct AssembleRecords {
  const double* mass;
  const double* half_density;
  const double* half_pressure;
  const double* half_sound_speed;
  const Symmetric<double, D>* half_deviatoric_stress;
  const double* thickness;
  const double* across_rate;
  double half_step;
  const double* smoothing_length;
  EulerianRecord<D>* records;

  void operator()(std::size_t i) const {
    EulerianRecord<D>& r = records[i];
    double b = 1.0;
    if constexpr (plane_stress) b = thickness[i] * std::exp(half_step * across_rate[i]);
    for (int k = 0; k < D; ++k)
      for (int m = k; m < D; ++m)
        r.stress[EulerianRecord<D>::index(k, m)] =
            b * (half_deviatoric_stress[i](k, m) - (k == m ? half_pressure[i] : 0.0));
    r.density = b * half_density[i];
    r.volume = mass[i] / r.density;
    r.sound_speed = half_sound_speed[i];
    r.smoothing_length = smoothing_length[i];
  }
};

}  // namespace tektite
