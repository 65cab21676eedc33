#pragma once

#include <algorithm>
#include <cmath>

#include "core/tensor.hpp"
#include "physics/damage/damage.hpp"

namespace tektite {

/// Damage by the plastic strain of a step; `temperature` may be null where nothing heats: then it is the room's.
template <class Damage, int D>
struct AdvanceDamage {
  Damage model;
  const double* plastic_increment;
  const double* pressure;
  const Symmetric<double, D>* stress;
  const double* temperature;
  double step;
  double* damage;

  void operator()(std::size_t i) const {
    if constexpr (requires { model.fails_under(0.0); }) {
      if (model.fails_under(pressure[i])) damage[i] = 1.0;
    }
    if (plastic_increment[i] <= 0.0) return;
    DamageState state{-pressure[i] / von_mises(stress[i]), plastic_increment[i] / step, 0.0, pressure[i]};
    if constexpr (requires { model.room_temperature; })
      state.temperature = temperature ? temperature[i] : model.room_temperature;
    const double strain = model.failure_strain(state);
    damage[i] = strain > 0.0 ? std::min(1.0, damage[i] + plastic_increment[i] / strain) : 1.0;
  }
};

/// A failed particle bears no shear, unless its strength model tells how much it bears.
template <int D>
struct ReleaseShear {
  const double* damage;
  Symmetric<double, D>* stress;

  void operator()(std::size_t i) const {
    if (damage[i] >= 1.0) stress[i] = Symmetric<double, D>::zero();
  }
};

/// Spall by a limit of pressure: none below p_min (the "pressure limit" of Young et al. 2021, section 3.3), and none
/// below zero where a particle has failed. `damage` may be null.
struct LimitTension {
  double least_pressure;
  const double* damage;
  double* pressure;

  void operator()(std::size_t i) const {
    const double least = damage && damage[i] >= 1.0 ? 0.0 : least_pressure;
    if (pressure[i] < least) pressure[i] = least;
  }
};

}  // namespace tektite
