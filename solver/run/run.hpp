#pragma once
// A run: from particles to snapshots, history and summary.

#include <string>

namespace tektite {

struct RunOptions {
  std::string folder;   ///< DIR of the run, which holds particles.h5
  bool resume = false;  ///< go on from the newest snapshot
  int threads = 0;      ///< 0: as many as there are
};

/// Computes the run to its end. False where it was interrupted (SIGINT, SIGTERM): a snapshot was written and the run
/// can be resumed. Throws InputError, or RunError where the computation fails.
bool run(const RunOptions& options);

/// Says what a run of these particles would do and cost; computes a few steps and writes nothing.
void forecast(const std::string& particle_file, int threads);

}  // namespace tektite
