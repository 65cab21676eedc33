#pragma once

#include "core/tensor.hpp"
#include "passes/across.hpp"
#include "passes/eulerian_record.hpp"

namespace tektite {

/// Brings velocity, place, density, energy and viscous work to the end of the step with the rates of its middle:
///   v += a dt,  x = x½ + v dt/2,  ρ *= e^(-(tr L + D_zz) dt),  e += (σ½:L/ρ½ + q) dt
template <int D, bool plane_stress>
struct AdvanceMotion {
  const EulerianRecord<D>* records;
  const Vector<double, D>* acceleration;
  const Tensor<double, D>* velocity_gradient;
  const double* viscous_power;
  const double* across_rate;
  double step;
  Vector<double, D>* position;
  Vector<double, D>* velocity;
  double* density;
  double* energy;
  double* viscous_work;

  void operator()(std::size_t i) const {
    velocity[i] = velocity[i] + step * acceleration[i];
    position[i] = records[i].x + (0.5 * step) * velocity[i];
    const auto& l = velocity_gradient[i];
    double power = 0.0;
    for (int r = 0; r < D; ++r)
      for (int c = 0; c < D; ++c) power += records[i].stress[EulerianRecord<D>::index(r, c)] * l(r, c);
    density[i] *= density_factor(step * (trace(l) + across<plane_stress>(across_rate, i)));
    energy[i] += step * (power / records[i].density + viscous_power[i]);
    viscous_work[i] += step * viscous_power[i];
  }
};

}  // namespace tektite
