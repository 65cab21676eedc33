// Runs of a study as children of this program.

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <map>

#include "core/error.hpp"
#include "front/held_signals.hpp"
#include "front/launcher.hpp"

namespace tektite::front {
namespace {

int code_of(int status) { return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status); }

/// Nothing that another launcher has in hand is touched.
void prepare(const std::vector<Job>& jobs) {
  for (const auto& job : jobs)
    if (std::filesystem::exists(job.files.task))
      throw InputError({{job.files.task.string(), 0},
                        {},
                        {},
                        "this run is a task of Slurm",
                        "--launcher slurm, which gathers it; or to cancel it and remove this file"});
  for (const auto& job : jobs) job.files.clear();
}

}  // namespace

void launch_locally(const std::vector<Job>& jobs, const Means& means, const Ended& ended) {
  prepare(jobs);
  const auto processors = static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN));
  const auto at_once = static_cast<std::size_t>(means.jobs > 0 ? means.jobs : std::max(1, processors / means.threads));
  const auto program = std::filesystem::read_symlink("/proc/self/exe").string();
  const HeldSignals signals({SIGINT, SIGTERM, SIGCHLD});
  std::map<pid_t, std::size_t> running;
  std::size_t next = 0;
  bool interrupted = false;
  while (!running.empty() || (next < jobs.size() && !interrupted)) {
    while (!interrupted && next < jobs.size() && running.size() < at_once) {
      const auto& job = jobs[next];
      running[spawn(program, job.arguments, {job.files.log, job.files.faults}, signals.before())] = next;
      ++next;
    }
    const int signal = signals.wait();
    if (signal == SIGINT || signal == SIGTERM) interrupted = true;
    if (signal == SIGTERM)
      for (const auto& [process, job] : running) ::kill(process, SIGTERM);
    int status = 0;
    for (pid_t process = ::waitpid(-1, &status, WNOHANG); process > 0; process = ::waitpid(-1, &status, WNOHANG)) {
      const auto found = running.find(process);
      if (found == running.end()) continue;
      if (!interrupted) ended(found->second, failure_of(jobs[found->second].files, code_of(status)));
      running.erase(found);
    }
  }
  if (interrupted) throw RunError("interrupted; the same command goes on with what is missing");
}

}  // namespace tektite::front
