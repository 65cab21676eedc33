#include "front/several.hpp"

#include <sys/wait.h>

#include <csignal>
#include <filesystem>
#include <map>

#include "core/error.hpp"

namespace tektite::front {
namespace {

/// While it lives, the signals that matter here wait until they are asked for.
class HeldSignals {
 public:
  HeldSignals() {
    sigemptyset(&held_);
    for (const int signal : {SIGINT, SIGTERM, SIGCHLD}) sigaddset(&held_, signal);
    ::sigprocmask(SIG_BLOCK, &held_, &before_);
  }
  ~HeldSignals() { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
  int wait() const { return ::sigwaitinfo(&held_, nullptr); }
  const sigset_t& before() const { return before_; }

 private:
  sigset_t held_, before_;
};

int code_of(int status) { return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status); }

}  // namespace

void run_several(const std::vector<Job>& jobs, int at_once, const Ended& ended) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe").string();
  const HeldSignals signals;
  std::map<pid_t, std::size_t> running;
  std::size_t next = 0;
  bool interrupted = false;
  while (!running.empty() || (next < jobs.size() && !interrupted)) {
    while (!interrupted && next < jobs.size() && running.size() < static_cast<std::size_t>(at_once)) {
      const auto& job = jobs[next];
      running[spawn(program, job.arguments, {job.log, job.fault}, signals.before())] = next;
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
      if (!interrupted) ended(found->second, code_of(status));
      running.erase(found);
    }
  }
  if (interrupted) throw RunError("interrupted; the same command goes on with what is missing");
}

}  // namespace tektite::front
