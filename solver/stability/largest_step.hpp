#pragma once
// How long a time step may be before waves grow by it, measured on the real step.

#include "stability/amplification.hpp"

namespace tektite {

/// Growth times δ/c up to which a scheme counts as stable: a mode that grows e-fold while a wave runs through a hundred
/// particles. Leapfrogs whose stress is predicted with the strain rates of the step before let waves grow by a part of
/// Δt³ where no viscosity damps them, so that no step at all would be stable by zero.
inline constexpr double tolerable_growth = 0.01;

struct LargestStep {
  double share = 0.0;   ///< of the time step that the scheme takes: below one its own is too long
  double in_use = 0.0;  ///< that time step, times c/δ
};

/// Within a hundredth; a share of 64 means that none up to there is too long, zero that none down to 1/64 is stable.
LargestStep largest_stable_step(const RunSettings& settings, const LatticeState& state, int wave_steps);

}  // namespace tektite
