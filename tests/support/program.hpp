#pragma once
// A program of tektite run as a user runs it.

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace tektite::test {

struct Outcome {
  int code = 0;  ///< the exit code, or -1 where a signal ended the program
  std::string output;
  std::string faults;  ///< what stood on standard error
};

inline std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs words[0] with the arguments words[1]... in `folder` and waits for it; `prepare` is called in its process first.
inline Outcome run_in(
    const std::string& folder, std::vector<std::string> words, void (*prepare)() = [] {}) {
  const TemporaryFolder capture;
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const auto output = capture.file("output"), faults = capture.file("faults");
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process can be started");
  if (child == 0) {
    ::dup2(::open(output.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
    ::dup2(::open(faults.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
    prepare();
    if (::chdir(folder.c_str()) == 0) ::execv(arguments[0], arguments.data());
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(output), content_of(faults)};
}

/// To be called before a program starts that may run wild: it and what it starts is ended after a minute of processor
/// time each, and gets no more than 8 GB of address space.
inline void limit_resources() {
  constexpr rlim_t seconds = 60;
  constexpr rlim_t bytes = rlim_t{8} << 30;
  const rlimit time{seconds, seconds}, memory{bytes, bytes};
  ::setrlimit(RLIMIT_CPU, &time);
  ::setrlimit(RLIMIT_AS, &memory);
}

}  // namespace tektite::test
