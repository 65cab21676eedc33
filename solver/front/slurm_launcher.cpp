// Runs of a study as tasks of Slurm's job arrays. What is under way stands in files alone, so that it is found again
// whatever becomes of this program:
//
//   DIR/slurm/N.sh, N.job         a submission: the script of its tasks, and its job as sbatch has told it
//   DIR/slurm/N-INDEX.log         what Slurm says of a task
//   DIR/runs/NAME.task            which task has the run, how often it has been submitted, what decides over its result
//   DIR/runs/NAME.ended           the exit code of a run that has come to its own end, written by its task

#include <fmt/format.h>

#include <set>
#include <sstream>

#include "core/error.hpp"
#include "core/write_beside.hpp"
#include "front/held_signals.hpp"
#include "front/launcher.hpp"
#include "front/slurm.hpp"

namespace tektite::front {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;

/// A run is submitted so often, where its task ends without it: a node fails, a time limit, scancel, SIGKILL.
constexpr int most_submissions = 3;
/// Slurm is asked soon after something has happened, and then less and less often.
constexpr seconds first_pause(1), longest_pause(30);

/// Which task has a run, and how often the run has been submitted.
struct Task {
  int submission = 0;
  int index = 0;
  int times = 0;
};

/// A task as it stands in a file: its numbers in the first line, then what decides over the result.
std::string text_of(const Task& task, const std::string& identity) {
  return fmt::format("{} {} {}\n{}", task.submission, task.index, task.times, identity);
}

Task task_in(const fs::path& file) {
  std::istringstream words(content_of(file));
  Task task;
  words >> task.submission >> task.index >> task.times;
  return task;
}

bool is_of(const fs::path& file, const std::string& identity) {
  const auto text = content_of(file);
  return text.substr(text.find('\n') + 1) == identity;
}

std::string tasks(std::size_t runs) { return runs == 1 ? "1 run is a task" : fmt::format("{} runs are tasks", runs); }

class SlurmLauncher {
 public:
  SlurmLauncher(const std::vector<Job>& jobs, const Means& means, const Ended& ended)
      : jobs_(jobs), means_(means), ended_(ended), slurm_(means.folder / "slurm", signals_.held(), signals_.before()) {
    fs::create_directories(means.folder / "slurm");
  }

  void run() {
    submit(find_tasks());
    auto pause = first_pause;
    while (!tasks_.empty()) {
      pause = gather() ? first_pause : std::min(2 * pause, longest_pause);
      if (!tasks_.empty() && signals_.come_within(pause)) throw interrupted();
    }
  }

 private:
  /// Runs by number, with how often they have been submitted.
  using Submissions = std::map<std::size_t, int>;

  std::string job_of(const Task& task) const { return slurm_.job(task.submission); }
  /// As Slurm's own commands take it.
  std::string name_of(const Task& task) const { return fmt::format("{}_{}", job_of(task), task.index); }

  /// Takes the tasks of an earlier call for its own; the other runs are to be submitted.
  Submissions find_tasks() {
    Submissions others;
    std::optional<Queue> queue;
    for (std::size_t k = 0; k < jobs_.size(); ++k) {
      const auto& job = jobs_[k];
      if (!fs::exists(job.files.task)) {
        others[k] = 0;
        continue;
      }
      const auto task = task_in(job.files.task);
      if (!means_.replace && is_of(job.files.task, job.identity)) {
        tasks_[k] = task;
        continue;
      }
      if (!queue) queue = slurm_.queue();
      if (!queue) throw RunError("squeue: " + slurm_.last_words());
      if (in_hand(*queue, job_of(task), task.index))
        throw InputError({{job.name, 0},
                          {},
                          {},
                          fmt::format("an earlier run of this name is task {} of Slurm", name_of(task)),
                          fmt::format("`scancel {}`, or to wait for its end", name_of(task))});
      others[k] = 0;
    }
    if (!tasks_.empty()) fmt::print("{} of Slurm already\n", tasks(tasks_.size()));
    return others;
  }

  void submit(const Submissions& runs) {
    if (runs.empty()) return;
    const int number = slurm_.next_number();
    std::vector<const Job*> array;
    for (const auto& [run, times] : runs) array.push_back(&jobs_[run]);
    write_text_beside(slurm_.script(number), script_of(array, slurm_.job_file(number)));
    int index = 0;
    for (const auto& [run, times] : runs) {
      const auto& job = jobs_[run];
      const Task task{number, index++, times + 1};
      job.files.clear();
      write_text_beside(job.files.task, text_of(task, job.identity));
      tasks_[run] = task;
    }
    try {
      slurm_.submit(number, options(number, array.size()));
      check_that_it_shows(number);
    } catch (...) {
      for (const auto* job : array) fs::remove(job->files.task);
      slurm_.withdraw(number);
      throw;
    }
    const auto job = slurm_.job(number);
    fmt::print("{} of Slurm's job {} (to give up: Ctrl-C, then `scancel {}`)\n", tasks(array.size()), job, job);
    std::fflush(stdout);
  }

  /// What is not to be changed stands behind the user's own options, and rules.
  Words options(int number, std::size_t count) const {
    Words words{"--job-name=tektite-" + means_.study};
    for (const auto& option : means_.sbatch) words.push_back("--" + option);
    const auto at_once = means_.jobs > 0 ? fmt::format("%{}", means_.jobs) : std::string();
    words.insert(words.end(), {fmt::format("--array=0-{}{}", count - 1, at_once), "--no-requeue",
                               fmt::format("--cpus-per-task={}", means_.threads),
                               fmt::format("--output={}", slurm_.log(number, "%a").string())});
    return words;
  }

  /// A task that squeue does not show counts as ended, so a new one must be there.
  void check_that_it_shows(int number) const {
    const auto queue = slurm_.queue();
    const auto job = slurm_.job(number);
    if (queue && !queue->contains({job, 0}))
      throw RunError(fmt::format(
          "squeue does not show job {}, which sbatch has submitted: cancel it, and have both speak to one cluster",
          job));
  }

  /// Ends what has ended and submits again what has been ended from outside; whether anything has.
  bool gather() {
    const auto queue = slurm_.queue();  // before the files: who is gone has left them
    tell_whether_it_answers(queue.has_value());
    const auto ends = ends_that_are_there();
    const auto before = tasks_.size();
    Submissions lost;
    for (auto next = tasks_.begin(); next != tasks_.end();) {
      const auto [run, task] = *next;
      const auto& files = jobs_[run].files;
      const bool has_ended = ends.contains(files.end);
      if (!has_ended && (!queue || in_hand(*queue, job_of(task), task.index))) {
        ++next;
        continue;
      }
      next = tasks_.erase(next);
      if (has_ended) {
        end(run, failure_of(files, std::stoi(content_of(files.end))));
      } else if (task.times < most_submissions) {
        fmt::print("{}: {}; it is submitted again\n", jobs_[run].name, loss_of(task, *queue));
        lost[run] = task.times;
      } else {
        end(run, fmt::format("{}, after {} submissions", loss_of(task, *queue), task.times));
      }
    }
    const bool anything = tasks_.size() < before;
    submit(lost);
    return anything;
  }

  void end(std::size_t run, const std::string& failure) {
    ended_(run, failure);
    fs::remove(jobs_[run].files.task);
    fs::remove(jobs_[run].files.end);
  }

  /// From the list of the folder, which a file server is asked for anew; of a single file it may be remembered that it
  /// was not there.
  std::set<fs::path> ends_that_are_there() const {
    std::set<fs::path> ends;
    for (const auto& entry : fs::directory_iterator(means_.folder / "runs"))
      if (entry.path().extension() == ".ended") ends.insert(entry.path());
    return ends;
  }

  /// What Slurm says of a task that has ended without its run: its state, and the last line of its log.
  std::string loss_of(const Task& task, const Queue& queue) const {
    if (job_of(task).empty()) return "sbatch had not submitted it";
    const auto found = queue.find({job_of(task), task.index});
    auto words = fmt::format("task {} has ended without it", name_of(task));
    if (found != queue.end()) words += ", " + found->second;
    std::istringstream lines(content_of(slurm_.log(task.submission, std::to_string(task.index))));
    std::string line, last;
    while (std::getline(lines, line)) last = line;
    return last.empty() ? words : words + ": " + last;
  }

  void tell_whether_it_answers(bool answers) {
    if (answers_ && !answers) fmt::print("Slurm does not answer ({}); it is asked again\n", slurm_.last_words());
    answers_ = answers;
    std::fflush(stdout);
  }

  RunError interrupted() const {
    std::set<std::string> ids;
    for (const auto& [run, task] : tasks_) ids.insert(job_of(task));
    std::string words;
    for (const auto& id : ids) words += ' ' + id;
    return RunError(fmt::format(
        "interrupted; Slurm goes on with the runs: the same command gathers them, `scancel{}` cancels them", words));
  }

  HeldSignals signals_{SIGINT, SIGTERM};
  const std::vector<Job>& jobs_;
  const Means& means_;
  const Ended& ended_;
  Slurm slurm_;
  std::map<std::size_t, Task> tasks_;  ///< of the runs that have not ended
  bool answers_ = true;
};

}  // namespace

void launch_by_slurm(const std::vector<Job>& jobs, const Means& means, const Ended& ended) {
  SlurmLauncher(jobs, means, ended).run();
}

}  // namespace tektite::front
