#pragma once
// Slurm as a user has it: sbatch and squeue, which keep what they say in files of one folder.

#include <csignal>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "front/launcher.hpp"

namespace tektite::front {

/// What squeue tells of the user's tasks by job array and index: their states, such as RUNNING. Slurm forgets tasks
/// some minutes after their end.
using Queue = std::map<std::pair<std::string, int>, std::string>;

/// Whether Slurm has a task in hand: it waits, runs, or is about to end.
bool in_hand(const Queue& queue, const std::string& job, int index);

/// The script of a job array, a run a task. A task starts its run when it reads its own job in `job_file`: where sbatch
/// could not tell the job, it has to be nobody's. It leaves the exit code where the end is the run's own: neither
/// Slurm, by SIGTERM, nor a signal to the run has brought it about.
std::string script_of(const std::vector<const Job*>& jobs, const std::filesystem::path& job_file);

class Slurm {
 public:
  /// Ctrl-C, which reaches the children too, ends squeue; sbatch comes to its end, so that no job goes unknown.
  Slurm(std::filesystem::path folder, const sigset_t& held_back, const sigset_t& let_through)
      : folder_(std::move(folder)), held_back_(held_back), let_through_(let_through) {}

  /// The files of a submission, DIR/slurm/NUMBER and an ending.
  std::filesystem::path script(int number) const { return folder_ / (std::to_string(number) + ".sh"); }
  /// What sbatch says of the job: written by sbatch itself, so that it is there even if this program is killed.
  std::filesystem::path job_file(int number) const { return folder_ / (std::to_string(number) + ".job"); }
  std::filesystem::path log(int number, const std::string& index) const {
    return folder_ / (std::to_string(number) + "-" + index + ".log");
  }
  /// The job of a submission; empty where sbatch came to none.
  std::string job(int number) const;
  /// A number that no submission has yet.
  int next_number() const;

  /// Submits the script of this number with these options. Throws RunError, with what sbatch says, where it refuses.
  void submit(int number, const Words& options) const;
  /// Takes away the files of a submission that has failed; a task that it should have nevertheless finds no job in
  /// them.
  void withdraw(int number) const;
  /// Nullopt where Slurm does not answer; `last_words` then tells why.
  std::optional<Queue> queue() const;
  std::string last_words() const;

 private:
  int call(const Words& words, const std::filesystem::path& output, const sigset_t& mask) const;
  std::filesystem::path faults() const { return folder_ / "faults"; }

  std::filesystem::path folder_;
  sigset_t held_back_, let_through_;
};

}  // namespace tektite::front
