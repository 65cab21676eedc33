#pragma once

namespace tektite {

/// What a failure strain may depend on.
struct DamageState {
  double triaxiality = 0.0;          ///< σ* = -p / √(3/2 s:s)
  double plastic_strain_rate = 0.0;  ///< 1/s
  double temperature = 0.0;          ///< K
  double pressure = 0.0;             ///< Pa
};

}  // namespace tektite
