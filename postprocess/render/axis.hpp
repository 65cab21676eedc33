#pragma once
// The numbers beside an axis.

#include <vector>

namespace tektite {

/// Multiples of a round step (1, 2 or 5 times a power of ten) from the last one that is not above all numbers to the
/// first that is not below them.
struct Axis {
  double least = 0.0, step = 1.0;
  int steps = 1;

  double tick(int k) const { return least + k * step; }
  double largest() const { return tick(steps); }
  /// Where a number is, from 0 at the least tick to 1 at the largest.
  double share(double number) const { return (number - least) / (largest() - least); }
};

/// With at most `most_steps` steps, if that is not below 4. Numbers that are not finite are left out.
Axis axis_of(double least, double largest, int most_steps);

/// The number, or zero where round-off is all that is left of it beside the step.
double without_round_off(double number, double step);

}  // namespace tektite
