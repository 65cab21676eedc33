#pragma once
// A run with everything that it writes. Every rank goes through the same; the first one alone writes and speaks, but
// for snapshots, which all write together.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "output/history.hpp"
#include "output/log.hpp"
#include "output/probes.hpp"
#include "output/progress.hpp"
#include "output/snapshot_writer.hpp"
#include "output/summary.hpp"
#include "run/simulation.hpp"
#include "run/stop_conditions.hpp"
#include "run/watch.hpp"

namespace tektite {

/// What a run starts from: its particles, or a snapshot.
struct Origin {
  std::string file;
  bool snapshot = false;
};

class RecordedRun {
 public:
  /// Who goes on with a run `beyond` its end keeps the snapshot of that. `interrupted` tells whether to end early, on
  /// all ranks at the same time.
  RecordedRun(std::filesystem::path folder, Origin origin, const RunTimer& timer, Simulation& simulation, bool beyond,
              std::function<bool()> interrupted);

  /// True where the run came to its end. Throws RunError where it fails, which its log keeps.
  bool to_the_end();

 private:
  Probes make_probes();
  std::optional<History> make_history() const;
  StopConditions make_stops();
  /// The first lines of the log, of the history, and the first snapshot.
  void begin(bool beyond);
  bool compute();

  /// At its end, or stopped by a condition.
  bool over() const { return simulation_.finished() || stops_.met(); }
  bool event_has_begun() const;
  bool snapshot_due() const;

  void write_snapshot();
  void finish_snapshot();
  void write_history();
  void show_progress();
  void look();
  void tell(const std::vector<Warning>& warnings);
  void settle();
  void note(const RunError& fault);
  void finish();

  std::filesystem::path folder_;
  Origin origin_;
  RunTimer timer_;
  Simulation& simulation_;
  std::function<bool()> interrupted_;
  std::shared_ptr<spdlog::logger> log_;
  Probes probes_;
  std::vector<std::string> columns_;  ///< of a line's numbers
  StopConditions stops_;
  Watch watch_;
  std::optional<History> history_;  ///< on the first rank
  Progress progress_;
  Ledger ledger_;
  std::string last_snapshot_;  ///< that is whole
  std::string stopgap_;        ///< written because a run was interrupted: an unbroken run has none
  struct {
    std::string path;
    double time;
    std::int64_t step;
  } begun_;                ///< what is being written
  SnapshotWriter writer_;  ///< stands last: it is waited for before anything else goes
};

}  // namespace tektite
