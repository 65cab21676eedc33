#include "stability/largest_step.hpp"

namespace tektite {

LargestStep largest_stable_step(const RunSettings& settings, const LatticeState& state, int wave_steps) {
  constexpr double farthest = 64.0, accuracy = 1.01;
  LargestStep largest;
  const auto stable = [&](double share) {
    const Amplification step(settings, state, share);
    largest.in_use = step.time_step() * step.wave_speed() / LatticeBlock::spacing / share;
    return fastest_growth(step, waves_of(step.dimensions(), wave_steps)).growth.rate <= tolerable_growth;
  };
  double low = 1.0, high = 1.0;
  if (stable(1.0)) {
    while (high < farthest && stable(2.0 * high)) high *= 2.0;
    if (high >= farthest) return largest.share = farthest, largest;
    low = high, high *= 2.0;
  } else {
    while (low > 1.0 / farthest && !stable(0.5 * low)) low *= 0.5;
    if (low <= 1.0 / farthest) return largest;
    high = low, low *= 0.5;
  }
  while (high > accuracy * low) {
    const double middle = std::sqrt(low * high);
    (stable(middle) ? low : high) = middle;
  }
  largest.share = low;
  return largest;
}

}  // namespace tektite
