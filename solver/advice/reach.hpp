#pragma once
// What no wave reaches before a run is over.

#include <map>
#include <string>
#include <vector>

#include "advice/impact.hpp"
#include "run/run_settings.hpp"

namespace tektite {

/// A body of which a box would do.
struct Trim {
  const Body* body = nullptr;
  std::vector<double> lower, upper;  ///< m; edges of whole cells
  std::size_t spared = 0;            ///< particles outside
  double distance = 0.0;             ///< how far waves come from the other bodies, m
};

/// Bodies that start in one piece at one velocity, wherever a part of them lies further from everything that moves
/// against them than waves can come in the time of the run.
std::vector<Trim> unreached(const Particles& particles, const RunSettings& settings,
                            const std::vector<Meeting>& meetings);

}  // namespace tektite
