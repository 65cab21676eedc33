#pragma once
// A Slurm cluster for a test, gone with it.

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "robustness/small_run.hpp"

namespace tektite::test {

/// While it lives, sbatch and the others speak to a cluster of two processors. Its end is that of the standard input of
/// the script `cluster`, so that it ends even where the test is killed.
class Cluster {
 public:
  Cluster() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe can be made");
    script_ = ::fork();
    if (script_ < 0) throw std::runtime_error("no process can be started");
    if (script_ == 0) {
      ::dup2(ends[0], STDIN_FILENO);
      ::execl(CLUSTER, CLUSTER, path().c_str(), "sh", "-c", ": >\"$0/ready\"; exec cat", path().c_str(), nullptr);
      ::_exit(127);
    }
    ::close(ends[0]);
    input_ = ends[1];
    const auto ready = [&] { return std::filesystem::exists(path() + "/ready") || has_ended(); };
    if (!comes_about(ready) || has_ended()) throw std::runtime_error("the cluster does not start");
    ::setenv("SLURM_CONF", (path() + "/slurm.conf").c_str(), 1);
  }
  ~Cluster() {
    ::close(input_);
    ::waitpid(script_, nullptr, 0);
  }
  Cluster(const Cluster&) = delete;
  Cluster& operator=(const Cluster&) = delete;

  /// How many tasks it has started.
  int starts() const {
    const auto log = content_of(path() + "/slurmd.log");
    const std::string mark = "Launching batch job";
    int count = 0;
    for (auto at = log.find(mark); at != std::string::npos; at = log.find(mark, at + 1)) ++count;
    return count;
  }

 private:
  std::string path() const { return folder_.file("cluster"); }
  bool has_ended() const {
    siginfo_t info{};
    return ::waitid(P_PID, static_cast<id_t>(script_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == script_;
  }

  TemporaryFolder folder_;
  pid_t script_ = 0;
  int input_ = -1;
};

}  // namespace tektite::test
