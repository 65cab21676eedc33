#pragma once
// What a run tells about itself when it is over: solve.json and the last lines of the log.

#include <spdlog/spdlog.h>
#include <chrono>
#include <optional>
#include <set>
#include <string>

#include "output/profile.hpp"
#include "run/simulation.hpp"

namespace tektite {

/// Wall and processor time since it was made.
class RunTimer {
 public:
  RunTimer();
  double wall_seconds() const;
  double cpu_seconds() const;

 private:
  std::chrono::steady_clock::time_point wall_;
  double cpu_;
};

struct RunSummary {
  std::string scheme;
  std::size_t particles = 0;
  std::int64_t steps = 0;
  std::int64_t steps_taken = 0;  ///< by this process
  double time = 0.0;
  std::optional<double> contact_time;
  int threads = 0;
  double wall_seconds = 0.0, cpu_seconds = 0.0;
  double particle_steps_per_second = 0.0;
  std::size_t peak_memory_bytes = 0;
  std::size_t bytes_per_particle = 0;  ///< fields, lists and records
  double energy_drift = 0.0, momentum_drift = 0.0;
  std::optional<double> angular_momentum_drift;  ///< where nothing outside of the scene takes it up
  bool interrupted = false;
  std::string stopped_by;          ///< the condition that ended the run before its time; may be empty
  std::set<std::string> warnings;  ///< names of what was found wrong on the way
};

/// `warnings` as a Watch has told them; those of the drifts are added where they matter.
RunSummary summarise(const Simulation& simulation, const RunTimer& timer, bool interrupted,
                     std::set<std::string> warnings);
void write_summary(const RunSummary& summary, const std::string& path);
void log_summary(const RunSummary& summary, const Profile& profile, spdlog::logger& log);

/// Bytes that this process had at its largest.
std::size_t peak_memory();

}  // namespace tektite
