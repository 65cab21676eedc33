#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "passes/time_step_limit.hpp"

namespace tektite {

/// The step that the viscosity between neighbours of the reference configuration stands. What velocities differ by from
/// particle to particle dies by
///   Γ = 2.6 (α c/2 + 2 β |μ|)/(λ h),
/// the sum over a line of particles for the shortest wave, with the derivative of Π: in a shock all pairs approach, and
/// elsewhere, where |μ| is small, half of them do. The least stretch λ is there because neighbours stay the same ones
/// where particles come nearer, and once more where the viscosity's h does not shrink with it. Forces belong to
/// velocities that the accelerations of the step before have carried to the middle of this one, which stand Γ Δt = 1.
template <int D>
struct ViscousStepLimit {
  using Least = typename TimeStepLimit<D>::Least;

  const std::int64_t* id;
  double courant;
  double alpha;
  double beta;
  bool shrinks;  ///< the viscosity's h, with the stretch
  const double* smoothing_length;
  const double* sound_speed;
  const double* viscous_signal;
  const double* least_stretch;  ///< λ

  static constexpr double rate = 2.6;
  static constexpr double usual = 0.25;  ///< Courant number; with a smaller one these steps are shorter too

  void operator()(Least& least, std::size_t i) const {
    const double stretch = shrinks ? least_stretch[i] : least_stretch[i] * least_stretch[i];
    const double signal = rate * (0.5 * alpha * sound_speed[i] + 2.0 * beta * viscous_signal[i]);
    const double dt = limit_of(std::min(1.0, courant / usual) * stretch * smoothing_length[i], signal);
    if (dt <= least.dt) TimeStepLimit<D>::join(least, {dt, id[i], StepLimit::viscosity});
  }
};

}  // namespace tektite
