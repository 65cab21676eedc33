#pragma once

#include <utility>

#include "core/pack.hpp"

namespace tektite {

/// The smoothing length of a pair where all particles have the same one.
struct UniformSmoothing {
  Pack h;
  Pack inverse;
  explicit UniformSmoothing(double length) : h(length), inverse(1.0 / length) {}
  Pack of_pair(const Pack&, const Pack&) const { return h; }
  Pack inverse_of(const Pack&) const { return inverse; }
};

/// The mean of both, so that a pair sees one kernel and its forces are equal and opposite.
struct MeanSmoothing {
  Pack of_pair(const Pack& a, const Pack& b) const { return Pack(0.5) * (a + b); }
  Pack inverse_of(const Pack& h) const { return Pack(1.0) / h; }
};

/// sweep(smoothing) with what gives a pair's smoothing length, by the smallest and the largest h of all particles.
template <class Sweep>
void with_smoothing(const std::pair<double, double>& range, const Sweep& sweep) {
  if (range.first == range.second)
    sweep(UniformSmoothing(range.first));
  else
    sweep(MeanSmoothing{});
}

}  // namespace tektite
