#pragma once
// Faults of the system are made where they do no harm: in a process of its own.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <exception>
#include <stdexcept>
#include <string>

namespace tektite::test {

/// What the exception says by which `work` ends in a process of its own; nothing where it does its work.
template <class Work>
std::string fault_apart(const Work& work) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe can be made");
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process can be started");
  if (child == 0) {
    try {
      work();
    } catch (const std::exception& fault) {
      const std::string what = fault.what();
      if (::write(ends[1], what.data(), what.size()) < 0) ::_exit(1);
    }
    ::_exit(0);
  }
  ::close(ends[1]);
  std::string said;
  std::array<char, 4096> part{};
  for (ssize_t count = 0; (count = ::read(ends[0], part.data(), part.size())) > 0;)
    said.append(part.data(), static_cast<std::size_t>(count));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw std::runtime_error("the process ended early");
  return said;
}

/// From now on no file grows beyond so many bytes, as on a disk that is full.
inline void leave_room(rlim_t bytes) {
  ::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{bytes, bytes};
  ::setrlimit(RLIMIT_FSIZE, &limit);
}

/// From now on no process can be started. The limit does not bind root, who becomes nobody.
inline void allow_no_process() {
  constexpr uid_t nobody = 65534;
  if (::geteuid() == 0 && ::setuid(nobody) != 0) ::_exit(1);
  const rlimit limit{1, 1};
  ::setrlimit(RLIMIT_NPROC, &limit);
}

}  // namespace tektite::test
