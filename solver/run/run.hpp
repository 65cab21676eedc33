#pragma once
// A run: from particles to snapshots, history and summary.

#include <string>

namespace tektite {

struct RunOptions {
  std::string folder;                ///< DIR of the run, which holds particles.h5
  bool resume = false;               ///< go on from the newest snapshot; where there is none yet, from the start
  std::string end;                   ///< of a resumed run, in place of the scene's time.end; empty: as it was
  int threads = 0;                   ///< 0: as many as there are
  int lock = -1;                     ///< the open file of a lock of the folder that is handed down; negative: take one
  bool trap_floating_point = false;  ///< end at the first division by zero, overflow or undefined result
};

/// Computes the run to its end. False where it was interrupted (SIGINT, SIGTERM): a snapshot was written and the run
/// can be resumed. Throws InputError, or RunError where the computation fails.
bool run(const RunOptions& options);

}  // namespace tektite
