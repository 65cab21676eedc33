#pragma once

#include <cmath>

#include "physics/eos/eos.hpp"

namespace tektite {

/// Pressure and sound speed of a material's particles. In tension the sound speed leaves out the term p/ρ² ∂p/∂e, which
/// would make it imaginary for the loose particles of a debris cloud.
template <class Eos>
struct EvaluateEos {
  Eos eos;
  const double* density;
  const double* energy;
  double* pressure;
  double* sound_speed;

  void operator()(std::size_t i) const {
    const double rho = density[i];
    const double p = eos.pressure(rho, energy[i]);
    const double heating = p > 0.0 ? p / (rho * rho) * eos.pressure_by_energy(rho, energy[i]) : 0.0;
    pressure[i] = p;
    sound_speed[i] = std::sqrt(eos.pressure_by_density(rho, energy[i]) + heating);
  }
};

/// Speed of the longitudinal wave, c_l² = c² + 4G/(3ρ), which limits the time step.
struct EvaluateWaveSpeed {
  double shear_modulus;
  const double* density;
  const double* sound_speed;
  double* wave_speed;

  void operator()(std::size_t i) const {
    wave_speed[i] = std::sqrt(sound_speed[i] * sound_speed[i] + 4.0 / 3.0 * shear_modulus / density[i]);
  }
};

}  // namespace tektite
