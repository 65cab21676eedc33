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
    DamageState state{triaxiality(pressure[i], von_mises(stress[i])), plastic_increment[i] / step, 0.0, pressure[i]};
    if constexpr (requires { model.room_temperature; })
      state.temperature = temperature ? temperature[i] : model.room_temperature;
    const double strain = model.failure_strain(state);
    damage[i] = strain > 0.0 ? std::min(1.0, damage[i] + plastic_increment[i] / strain) : 1.0;
  }
};

/// The same with bulking: what fails in this step gets its ΔP. What strength is left is that at the reference rate.
template <class Damage, class Strength, int D>
struct AdvanceDamageAndBulk {
  AdvanceDamage<Damage, D> advance;
  Strength strength;
  double bulk_modulus;       ///< K1, Pa
  double* bulking_pressure;  ///< ΔP, Pa

  void operator()(std::size_t i) const {
    const bool intact = advance.damage[i] < 1.0;
    advance(i);
    if (!intact || advance.damage[i] < 1.0) return;
    const double pressure = advance.pressure[i], before = von_mises(advance.stress[i]);
    double after = 0.0;
    if constexpr (Strength::kind.crushes)
      after = std::min(before, strength.flow_stress({0.0, 0.0, 0.0, pressure, 1.0}));
    const double lost = (before * before - after * after) / (6.0 * strength.shear_modulus);
    bulking_pressure[i] = advance.model.bulking_pressure(pressure, bulk_modulus, lost);
  }
};

/// ΔP stays on top of what the equation of state gives.
struct AddBulking {
  const double* bulking_pressure;
  double* pressure;

  void operator()(std::size_t i) const { pressure[i] += bulking_pressure[i]; }
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
