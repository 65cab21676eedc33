#pragma once
// What turning about the axis adds to the scheme eulerian. A particle of the section acts as the membrane of plane
// stress does, with its circumference 2πr for a thickness: density, stress and volume of its record are those of the
// section. The ring's own force is -2π A 𝓢σ_θθ and its rate 𝓢v_r/r (ring_sums.hpp), so that energy and the momentum
// along the axis are kept and the axis stays sound.

#include "core/tensor.hpp"
#include "passes/eulerian_record.hpp"
#include "passes/ring_sums.hpp"

namespace tektite {

/// The ring's rate on the way to the middle of a step: v_r/r, on the axis ∂v_r/∂r.
struct PredictRings {
  const Vector<double, 2>* position;
  const Vector<double, 2>* velocity;
  const Tensor<double, 2>* velocity_gradient;
  double* across_rate;  ///< 1/s

  void operator()(std::size_t i) const {
    const double radius = position[i][0];
    across_rate[i] = radius > 0.0 ? velocity[i][0] / radius : velocity_gradient[i](0, 0);
  }
};

/// The circumference in the middle of a step; that of a particle on the axis follows its stretch.
struct MeasureRings {
  const EulerianRecord<2>* records;
  const double* stretch;
  const double* across_rate;
  double half_step;
  double spacing;
  double* circumference;

  void operator()(std::size_t i) const {
    const double radius = records[i].x[0];
    circumference[i] = tektite::circumference(mean_radius(radius, spacing));
    if (!(radius > 0.0)) circumference[i] *= stretch[i] * std::exp(half_step * across_rate[i]);
  }
};

/// What pairs see of rings: radial velocity and q = 2π σ_θθ. On the axis σ_θθ acts by the rate of the radius.
struct ShowRings {
  const Symmetric<double, 2>* deviatoric_stress;
  const double* pressure;
  const double* circumference;
  EulerianRecord<2>* records;
  RingRecord<2>* rings;

  void operator()(std::size_t i) const {
    auto& r = records[i];
    const double hoop = deviatoric_stress[i].c[2] - pressure[i];
    const bool on_axis = !(r.x[0] > 0.0);
    if (on_axis) r.stress[0] += circumference[i] * hoop;
    rings[i] = {r.x, r.volume, r.smoothing_length, {r.v[0], on_axis ? 0.0 : 2.0 * std::numbers::pi * hoop}};
  }
};

/// The ring's rate and force in the middle of a step.
struct TurnRings {
  const RingRecord<2>* rings;
  const Vector<double, 2>* smoothed;  ///< 𝓢v_r, 𝓢q
  const Tensor<double, 2>* velocity_gradient;
  const double* mass;
  double* across_rate;
  Vector<double, 2>* acceleration;

  void operator()(std::size_t i) const {
    const double radius = rings[i].x[0];
    across_rate[i] = radius > 0.0 ? smoothed[i][0] / radius : velocity_gradient[i](0, 0);
    acceleration[i][0] -= rings[i].area / mass[i] * smoothed[i][1];
  }
};

/// The power of the ring's stress, σ_θθ D_θθ/ρ over `step`.
struct HeatRings {
  const Symmetric<double, 2>* deviatoric_stress;
  const double* pressure;
  const double* density;
  const double* across_rate;
  double step;
  double* energy;

  void operator()(std::size_t i) const {
    energy[i] += step * (deviatoric_stress[i].c[2] - pressure[i]) * across_rate[i] / density[i];
  }
};

}  // namespace tektite
