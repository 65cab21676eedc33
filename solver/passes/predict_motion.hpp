#pragma once

#include "core/tensor.hpp"
#include "passes/across.hpp"
#include "passes/eulerian_record.hpp"

namespace tektite {

/// Brings place, velocity, density and energy to the middle of the step with the rates of the step before (Verlet's
/// leapfrog in its drift-kick-drift form):
///   x½ = x + v dt/2,  v½ = v + a dt/2,  ρ½ = ρ e^(-(tr L + D_zz) dt/2),  e½ = e + (σ:L/ρ + q) dt/2
template <int D, bool plane_stress>
struct PredictMotion {
  const Vector<double, D>* position;
  const Vector<double, D>* velocity;
  const Vector<double, D>* acceleration;
  const Tensor<double, D>* velocity_gradient;
  const Symmetric<double, D>* deviatoric_stress;
  const double* density;
  const double* energy;
  const double* pressure;
  const double* viscous_power;
  const double* across_rate;
  double half_step;
  EulerianRecord<D>* records;
  double* half_density;
  double* half_energy;

  void operator()(std::size_t i) const {
    records[i].x = position[i] + half_step * velocity[i];
    records[i].v = velocity[i] + half_step * acceleration[i];
    const auto& l = velocity_gradient[i];
    half_density[i] = density[i] * density_factor(half_step * (trace(l) + across<plane_stress>(across_rate, i)));
    const double power = contract(deviatoric_stress[i], symmetric_part(l)) - pressure[i] * trace(l);
    half_energy[i] = energy[i] + half_step * (power / density[i] + viscous_power[i]);
  }
};

}  // namespace tektite
