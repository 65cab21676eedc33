#pragma once

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
  explicit MeanSmoothing(double) {}
  Pack of_pair(const Pack& a, const Pack& b) const { return Pack(0.5) * (a + b); }
  Pack inverse_of(const Pack& h) const { return Pack(1.0) / h; }
};

}  // namespace tektite
