#pragma once
// This program run several times at once, each time with another command line.

#include <functional>
#include <string>
#include <vector>

#include "front/stage.hpp"

namespace tektite::front {

struct Job {
  Words arguments;    ///< of `tektite`
  std::string log;    ///< file of its standard output
  std::string fault;  ///< file of its standard error
};

/// How a job ended: its exit code, or the negative number of the signal that ended it.
using Ended = std::function<void(std::size_t job, int code)>;

/// Runs the jobs in their order, at most `at_once` at the same time, and calls `ended` after each. Ctrl-C reaches the
/// jobs through the terminal, a SIGTERM is passed on to them; after either no other job is started, the running ones
/// are waited for without `ended` being called, and RunError is thrown.
void run_several(const std::vector<Job>& jobs, int at_once, const Ended& ended);

}  // namespace tektite::front
