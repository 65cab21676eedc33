#pragma once

#include "core/tensor.hpp"
#include "passes/across.hpp"
#include "passes/godunov_heat.hpp"
#include "passes/godunov_records.hpp"
#include "passes/membrane.hpp"

namespace tektite {

/// What the deviatoric half sees of a particle; `thickness` is read in plane stress only.
template <int D, bool plane_stress>
struct AssembleDeviatoric {
  const Vector<double, D>* position;
  const Vector<double, D>* velocity;
  const Symmetric<double, D>* deviatoric_stress;
  const double* mass;
  const double* density;
  const double* pressure;
  const double* thickness;
  const double* smoothing_length;
  DeviatoricRecord<D>* records;

  void operator()(std::size_t i) const {
    auto& r = records[i];
    const double b = membrane<plane_stress>(thickness, i);
    r.x = position[i];
    r.v = velocity[i];
    for (int k = 0; k < D; ++k)
      for (int m = k; m < D; ++m) r.stress[r.index(k, m)] = b * deviatoric_stress[i](k, m);
    r.density = b * density[i];
    r.volume = mass[i] / r.density;
    r.pressure = b * pressure[i];
    r.smoothing_length = smoothing_length[i];
  }
};

/// ṽ = v + Δṽ and ũ = u + (power - ½ Δṽ·dṽ/dt) Δt, which conserves energy exactly: the time-split Godunov paper,
/// eq. 30 and 32.
template <int D>
struct KickDeviatoric {
  const Vector<double, D>* acceleration;
  const double* power;
  double step;
  Vector<double, D>* velocity;
  double* energy;

  void operator()(std::size_t i) const {
    const auto change = step * acceleration[i];
    velocity[i] += change;
    energy[i] += step * (power[i] - 0.5 * dot(change, acceleration[i]));
  }
};

/// What the hydrodynamic half sees of a particle; `damage` may be null where nothing fails, and `thickness` is read in
/// plane stress only.
template <int D, bool plane_stress>
struct AssembleHydrodynamic {
  const Vector<double, D>* position;
  const Vector<double, D>* velocity;
  const double* mass;
  const double* density;
  const double* pressure;
  const double* sound_speed;
  const double* thickness;
  const double* smoothing_length;
  const double* damage;
  double shock_slope;
  HydrodynamicRecord<D>* records;

  void operator()(std::size_t i) const {
    auto& r = records[i];
    const double b = membrane<plane_stress>(thickness, i);
    r.x = position[i];
    r.v = velocity[i];
    r.density = b * density[i];
    r.pressure = b * pressure[i];
    r.sound_speed = sound_speed[i];
    r.shock_slope = shock_slope;
    r.inverse_slope = 1.0 / shock_slope;
    r.volume = mass[i] / r.density;
    r.smoothing_length = smoothing_length[i];
    r.failed = damage && damage[i] >= 1.0 ? 1.0 : 0.0;
  }
};

/// Velocity, energy and place at the end of the step: eq. 21, 31 and 34; the place moves with the velocity v + c Δv.
template <int D>
struct AdvanceGodunov {
  GodunovHeat<D> heat;
  double centring;  ///< c
  Vector<double, D>* position;
  Vector<double, D>* velocity;
  double* energy;

  void operator()(std::size_t i) const {
    const auto change = heat.change(i);
    position[i] += heat.step * (velocity[i] + centring * change);
    velocity[i] += change;
    energy[i] += heat.step * heat(i);
  }
};

/// The density there: eq. 22.
template <bool plane_stress>
struct AdvanceDensity {
  const double* divergence;
  const double* across_rate;
  double step;
  double* density;

  void operator()(std::size_t i) const {
    density[i] *= density_factor(step * (divergence[i] + across<plane_stress>(across_rate, i)));
  }
};

}  // namespace tektite
