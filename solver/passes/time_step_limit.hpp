#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/tensor.hpp"

namespace tektite {

/// Which criterion limits a time step.
enum class StepLimit { sound, viscosity, acceleration, contact, meeting, growth, end };

constexpr const char* name_of(StepLimit limit) {
  switch (limit) {
    case StepLimit::sound:
      return "sound";
    case StepLimit::viscosity:
      return "viscosity";
    case StepLimit::acceleration:
      return "acceleration";
    case StepLimit::contact:
      return "contact";
    case StepLimit::meeting:
      return "meeting";
    case StepLimit::growth:
      return "growth";
    case StepLimit::end:
      return "end";
  }
  return "";
}

/// a/b of a positive a; infinite, without a division by zero, where b is zero and nothing limits.
inline double limit_of(double a, double b) { return b == 0.0 ? a + std::numeric_limits<double>::infinity() : a / b; }

/// The stable time step of a particle and what sets it (Monaghan 1992):
///   C h / (c_l + 0.6 (α c + β |μ|max))   and   C √(h/|a|)
/// Where gradients are of the reference configuration and particles have come nearer by the stretch λ, C is at most
/// 0.75 λ: waves there pass h λ, and a lattice at its start stands one and a half times that (docs/stability.md).
template <int D>
struct TimeStepLimit {
  struct Least {
    double dt = std::numeric_limits<double>::infinity();
    std::int64_t particle = std::numeric_limits<std::int64_t>::max();  ///< id; of several the least
    StepLimit reason = StepLimit::sound;

    bool before(const Least& other) const { return dt < other.dt || (dt == other.dt && particle < other.particle); }
  };

  const std::int64_t* id;
  double courant;
  double alpha;
  double beta;
  const double* smoothing_length;
  const double* wave_speed;
  const double* sound_speed;
  const double* viscous_signal;
  const double* density;
  const Vector<double, D>* acceleration;
  const double* least_stretch;  ///< λ; null where all kernels are of the present configuration

  static constexpr double most_stretched = 0.75;

  /// Where anything is not a number, or a density not positive, the limit is zero: the run has to stop there.
  void operator()(Least& least, std::size_t i) const {
    const double h = smoothing_length[i];
    const double part = least_stretch ? std::min(courant, most_stretched * least_stretch[i]) : courant;
    const double viscous = 0.6 * (alpha * sound_speed[i] + beta * viscous_signal[i]);
    const double signal = limit_of(part * h, wave_speed[i] + viscous);
    const double force = courant * std::sqrt(limit_of(h, norm(acceleration[i])));
    const bool sane = density[i] > 0.0 && signal > 0.0 && force > 0.0;
    const double dt = sane ? (signal < force ? signal : force) : 0.0;
    if (dt > least.dt) return;
    const auto reason = viscous > wave_speed[i] ? StepLimit::viscosity : StepLimit::sound;
    join(least, {dt, id[i], signal < force ? reason : StepLimit::acceleration});
  }
  static void join(Least& whole, const Least& part) {
    if (part.before(whole)) whole = part;
  }
};

}  // namespace tektite
