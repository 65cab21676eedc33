#pragma once
// The stage programs as children of the front.

#include <csignal>
#include <string>
#include <vector>

#include "core/scene.hpp"

namespace tektite::front {

using Words = std::vector<std::string>;

/// The program of a stage, such as tektite-solve.
std::string program_of(Stage stage);

/// Whether what a stage says on standard output is shown. What it says on standard error always is.
enum class Show { output, nothing };

/// Runs the program of a stage, found beside this one, with these arguments and waits. SIGINT and SIGTERM are passed on
/// to the child, and the front outlives both; where the front itself is killed the child is told to end. Returns the
/// exit code of the child, which has told its own fault. Throws RunError where the program is not there, was ended by a
/// signal, or was interrupted and ended without a fault.
int run_stage(Stage stage, const Words& arguments, Show show = Show::output);

/// Files that a child writes to in place of this program's standard output and standard error; empty: none.
struct Streams {
  std::string output;
  std::string faults;
};

/// Starts a program, by its path or by a name that is looked for as the shell does, and gives its process. It takes
/// SIGINT, SIGTERM and SIGCHLD as it is usual and blocks the signals of `mask`. Throws RunError where it cannot be
/// started.
pid_t spawn(const std::string& path, const Words& arguments, const Streams& streams, const sigset_t& mask);

/// Becomes the program of a stage. Throws RunError where the program is not there.
[[noreturn]] void become_stage(Stage stage, const Words& arguments);

}  // namespace tektite::front
