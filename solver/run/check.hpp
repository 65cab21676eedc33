#pragma once
// What a scene would do, told before it is computed.

#include <optional>
#include <string>

namespace tektite {

struct CheckOptions {
  std::string particles;              ///< a file of initial particles
  std::optional<std::string> advice;  ///< the file for the settings that would reduce the scene; none: no advice
  int threads = 0;                    ///< 0: as many as there are
};

/// Says what a run of these particles would do and cost, and where asked what could be saved; computes a few steps.
void check(const CheckOptions& options);

}  // namespace tektite
