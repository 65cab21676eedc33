#pragma once
// How the runs of a study are brought to processors: on this machine (local_launcher.cpp) or by Slurm
// (slurm_launcher.cpp).

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "front/stage.hpp"

namespace tektite::front {

/// The files of a run of a study: its folder DIR/runs/NAME, and those beside it.
struct RunFiles {
  std::filesystem::path run;
  std::filesystem::path log, faults;  ///< what it printed
  std::filesystem::path failure;      ///< why it failed
  std::filesystem::path scene;        ///< what decides over its result, from its end on
  std::filesystem::path task;         ///< which task of Slurm has it, until its end
  std::filesystem::path end;          ///< the exit code that this task leaves

  RunFiles(const std::filesystem::path& folder, const std::string& name);
  /// Takes away what an earlier try has left.
  void clear() const;
};

std::string content_of(const std::filesystem::path& path);

/// Why a run failed that ended with this exit code, or by the signal of this negative number: the error that it has
/// told, without the program's name and in one line. Empty where it has not failed.
std::string failure_of(const RunFiles& files, int code);

struct Job {
  std::string name;
  std::string identity;  ///< what decides over its result
  Words arguments;       ///< of `tektite`
  RunFiles files;
};

struct Means {
  std::string study;             ///< its name
  std::filesystem::path folder;  ///< of the study
  int jobs = 0;                  ///< how many go at once; 0: as many as there is room for
  int threads = 1;               ///< of each
  bool replace = false;          ///< runs of an earlier call are not taken
  Words sbatch;                  ///< options for sbatch
};

/// A run has ended; `failure` is empty where it has its measures.
using Ended = std::function<void(std::size_t job, const std::string& failure)>;

/// Runs the jobs, the first ones first, and calls `ended` after each. Throws RunError where it is interrupted.
using Launcher = void (*)(const std::vector<Job>& jobs, const Means& means, const Ended& ended);

/// As children of this program. Ctrl-C reaches them through the terminal, a SIGTERM is passed on to them; after either
/// no other is started, and the running ones are waited for without `ended` being called. Throws InputError where a
/// task of Slurm has one of the runs.
void launch_locally(const std::vector<Job>& jobs, const Means& means, const Ended& ended);

/// As tasks of a job array, which go on where this program is interrupted or killed, and are found again. Throws
/// InputError where a task has a run that is not wanted any more, RunError where Slurm refuses.
void launch_by_slurm(const std::vector<Job>& jobs, const Means& means, const Ended& ended);

}  // namespace tektite::front
