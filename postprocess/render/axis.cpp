#include "postprocess/render/axis.hpp"

#include <algorithm>
#include <cmath>

namespace tektite {

namespace {

constexpr double round_off = 1e-6;  // in steps: far below what is seen, far above what arithmetic leaves

}  // namespace

Axis axis_of(double least, double largest, int most_steps) {
  // One number alone stands in the middle of an axis as wide as it is large.
  if (!(largest > least)) {
    const double half = least == 0.0 ? 1.0 : 0.5 * std::abs(least);
    return axis_of(least - half, least + half, most_steps);
  }
  double power = std::pow(10.0, std::floor(std::log10((largest - least) / most_steps)));
  for (;; power *= 10.0)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double step = digit * power;
      const double first = std::floor(least / step + round_off), last = std::ceil(largest / step - round_off);
      if (last - first <= most_steps) return {first * step, step, static_cast<int>(std::max(last - first, 1.0))};
    }
}

double without_round_off(double number, double step) {
  return std::abs(number) < round_off * std::abs(step) ? 0.0 : number;
}

}  // namespace tektite
