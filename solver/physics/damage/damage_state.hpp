#pragma once

#include <cmath>

namespace tektite {

/// σ* = -p/√(3/2 s:s) from the pressure and the equivalent stress, both in Pa; at most 1e6 either way, since molten and
/// failed material bears no shear.
inline double triaxiality(double pressure, double equivalent_stress) {
  constexpr double most = 1e6;
  if (std::abs(pressure) < most * equivalent_stress) return -pressure / equivalent_stress;
  return pressure == 0.0 ? 0.0 : std::copysign(most, -pressure);
}

/// What a failure strain may depend on.
struct DamageState {
  double triaxiality = 0.0;          ///< σ*
  double plastic_strain_rate = 0.0;  ///< 1/s
  double temperature = 0.0;          ///< K
  double pressure = 0.0;             ///< Pa
};

}  // namespace tektite
