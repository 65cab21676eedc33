#pragma once
// Snapshots, written while the run goes on.

#include <string>

#include "core/snapshot.hpp"
#include "output/history.hpp"
#include "parallel/background.hpp"

namespace tektite {

/// Writes one snapshot at a time, from a copy of the fields that are kept between steps. The copy stays for the next
/// one. Several ranks write together, and do not go on meanwhile.
class SnapshotWriter {
 public:
  /// Copies the state and begins to write it to `path`, behind the history so far, which has to reach as far, and which
  /// the first rank alone has. What was begun before has been finished.
  void start(const Snapshot& state, const std::string& path, const History* history);

  /// Whether one was begun, and not finished yet; and whether finish() would have to wait for it.
  bool busy() const { return begun_; }
  bool at_work() const { return writing_.at_work(); }
  /// Waits until the file is whole. Throws RunError where it could not be written.
  void finish() {
    begun_ = false;
    writing_.finish();
  }

 private:
  Snapshot copy_;
  bool begun_ = false;
  Background writing_;  ///< stands last: it is waited for before the copy goes
};

}  // namespace tektite
