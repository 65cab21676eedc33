#pragma once

#include <cstddef>

#include "passes/time_step_limit.hpp"

namespace tektite {

/// The stable time step of a particle without viscosity: C h/(c_l + w) with w = motion(i), a speed in m/s. As in
/// TimeStepLimit, it is zero where a state is not sane.
template <int D, class Motion>
struct AcousticStepLimit {
  using Least = typename TimeStepLimit<D>::Least;

  const std::int64_t* id;
  double courant;
  const double* smoothing_length;
  const double* wave_speed;
  const double* density;
  Motion motion;

  void operator()(Least& least, std::size_t i) const {
    const double limit = limit_of(courant * smoothing_length[i], wave_speed[i] + motion(i));
    const double dt = density[i] > 0.0 && limit > 0.0 ? limit : 0.0;
    if (dt <= least.dt) TimeStepLimit<D>::join(least, {dt, id[i], StepLimit::sound});
  }
};

}  // namespace tektite
