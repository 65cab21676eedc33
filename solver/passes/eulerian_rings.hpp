#pragma once
// What turning about the axis adds to the scheme eulerian. A particle of the section acts as the membrane of plane
// stress does, with its circumference for a thickness: density, stress and volume of its record are those of the
// section. Power and force of the ring's own stress are one another's adjoint (ring_section.hpp, ring_sums.hpp), so
// that energy and the momentum along the axis are kept and the axis stays sound.

#include "core/tensor.hpp"
#include "passes/eulerian_record.hpp"
#include "passes/ring_section.hpp"
#include "passes/ring_sums.hpp"

namespace tektite {

/// The ring's rate on the way to the middle of a step.
struct PredictRings {
  const Vector<double, 2>* position;
  const Vector<double, 2>* velocity;
  const Tensor<double, 2>* velocity_gradient;
  const double* mass;
  const double* density;
  double* across_rate;  ///< 1/s

  void operator()(std::size_t i) const {
    const double radius = position[i][0];
    const auto ring = section_of_ring(radius, mass[i] / density[i]);
    const double outward = velocity_gradient[i](0, 0);
    across_rate[i] = radius != 0.0 ? (ring.share * velocity[i][0] + ring.arm * outward) / ring.mean_radius : outward;
  }
};

/// The sections of rings in the middle of a step. A particle on the axis has half a cell, which follows its stretch.
struct MeasureRings {
  const EulerianRecord<2>* records;
  const double* mass;
  const double* half_density;
  const double* stretch;
  const double* across_rate;
  double half_step;
  double spacing;
  RingSection* sections;
  double* circumference;

  void operator()(std::size_t i) const {
    const double radius = records[i].x[0];
    auto& ring = sections[i];
    if (radius != 0.0) {
      ring = section_of_ring(radius, mass[i] / half_density[i]);
    } else {
      const double mean = mean_radius(radius, spacing) * stretch[i] * std::exp(half_step * across_rate[i]);
      ring = {mean, 0.0, mean};
    }
    circumference[i] = tektite::circumference(ring.mean_radius);
  }
};

/// What pairs see of rings: radial velocity and q, what of 2π σ_θθ acts by the ring's own motion. The rest acts by the
/// rate of the radius within the section.
struct ShowRings {
  const Symmetric<double, 2>* deviatoric_stress;
  const double* pressure;
  const RingSection* sections;
  EulerianRecord<2>* records;
  RingRecord<2>* rings;

  void operator()(std::size_t i) const {
    auto& r = records[i];
    const auto& ring = sections[i];
    const double hoop = 2.0 * std::numbers::pi * (deviatoric_stress[i].c[2] - pressure[i]);
    r.stress[0] += ring.arm * hoop;
    rings[i] = {r.x, r.volume, r.smoothing_length, {r.v[0], ring.share * hoop}};
  }
};

/// The ring's rate and force in the middle of a step.
struct TurnRings {
  const RingRecord<2>* rings;
  const RingSection* sections;
  const Vector<double, 2>* smoothed;  ///< 𝓢v_r, 𝓢q
  const Tensor<double, 2>* velocity_gradient;
  const double* mass;
  double* own_rate;  ///< what of the rate the ring's own motion makes, 1/s
  double* across_rate;
  Vector<double, 2>* acceleration;

  void operator()(std::size_t i) const {
    const auto& ring = sections[i];
    own_rate[i] = ring.share / ring.mean_radius * smoothed[i][0];
    across_rate[i] = own_rate[i] + ring.arm / ring.mean_radius * velocity_gradient[i](0, 0);
    acceleration[i][0] -= rings[i].area / mass[i] * smoothed[i][1];
  }
};

/// The power of the ring's stress at this rate, σ_θθ D_θθ/ρ over `step`.
struct HeatRings {
  const Symmetric<double, 2>* deviatoric_stress;
  const double* pressure;
  const double* density;
  const double* rate;
  double step;
  double* energy;

  void operator()(std::size_t i) const {
    energy[i] += step * (deviatoric_stress[i].c[2] - pressure[i]) * rate[i] / density[i];
  }
};

/// A ring that has passed through the axis comes out of it: everything that is odd in the radius changes its sign.
struct PassThroughAxis {
  Vector<double, 2>* position;
  Vector<double, 2>* velocity;
  Vector<double, 2>* acceleration;
  Tensor<double, 2>* velocity_gradient;
  Symmetric<double, 2>* deviatoric_stress;

  void operator()(std::size_t i) const {
    if (!(position[i][0] < 0.0)) return;
    for (auto* odd : {&position[i][0], &velocity[i][0], &acceleration[i][0], &velocity_gradient[i](0, 1),
                      &velocity_gradient[i](1, 0), &deviatoric_stress[i](0, 1)})
      *odd = -*odd;
  }
};

}  // namespace tektite
