#pragma once

#include "passes/across.hpp"
#include "passes/side_by_side.hpp"
#include "physics/strength/advance_deviator.hpp"

namespace tektite {

/// The deviatoric stress of a material's particles in the middle of a step, for the forces only: nothing is kept of the
/// plastic flow on the way there.
template <class Strength, int D, bool plane_stress>
struct PredictStrength {
  Strength strength;
  const Tensor<double, D>* velocity_gradient;
  const double* across_rate;
  const double* density;
  const Symmetric<double, D>* stress;
  const double* plastic_strain;
  const double* temperature;
  const double* pressure;
  const double* damage;  ///< may be null where nothing fails
  double half_step;
  Symmetric<double, D>* half_stress;

  void operator()(const SideBySide& i) const {
    DeviatorState<D, WidePack> state{read(stress, i), 0.0, 0.0, 0.0};
    if constexpr (Strength::kind.yields) state.plastic_strain = read(plastic_strain, i);
    if constexpr (Strength::kind.heats) state.temperature = read(temperature, i);
    if constexpr (Strength::kind.crushes) {
      state.pressure = read(pressure, i);
      if (damage) state.damage = read(damage, i);
    }
    advance_deviator(strength, read(velocity_gradient, i), across<plane_stress>(across_rate, i), read(density, i),
                     half_step, state);
    write(half_stress, i, state.stress);
  }
};

/// The deviatoric stress and what plastic flow leaves behind, at the end of a step.
template <class Strength, int D, bool plane_stress>
struct AdvanceStrength {
  Strength strength;
  const Tensor<double, D>* velocity_gradient;
  const double* across_rate;
  const double* density;
  double step;
  Symmetric<double, D>* stress;
  double* plastic_strain;
  double* plastic_work;
  double* temperature;
  const double* pressure;
  const double* damage;       ///< may be null where nothing fails
  double* plastic_increment;  ///< may be null where nothing is damaged by it

  void operator()(const SideBySide& i) const {
    DeviatorState<D, WidePack> state{read(stress, i), 0.0, 0.0, 0.0};
    if constexpr (Strength::kind.yields) {
      state.plastic_strain = read(plastic_strain, i);
      state.plastic_work = read(plastic_work, i);
    }
    if constexpr (Strength::kind.heats) state.temperature = read(temperature, i);
    if constexpr (Strength::kind.crushes) {
      state.pressure = read(pressure, i);
      if (damage) state.damage = read(damage, i);
    }
    const WidePack strain = state.plastic_strain;
    advance_deviator(strength, read(velocity_gradient, i), across<plane_stress>(across_rate, i), read(density, i), step,
                     state);
    write(stress, i, state.stress);
    if constexpr (Strength::kind.yields) {
      if (plastic_increment) write(plastic_increment, i, WidePack(state.plastic_strain - strain));
      write(plastic_strain, i, state.plastic_strain);
      write(plastic_work, i, state.plastic_work);
    }
    if constexpr (Strength::kind.heats) write(temperature, i, state.temperature);
  }
};

}  // namespace tektite
