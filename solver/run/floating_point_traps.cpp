#include "run/floating_point_traps.hpp"

#include <execinfo.h>
#include <fenv.h>
#include <unistd.h>

#include <csignal>
#include <string_view>

#include "core/program.hpp"
#include "parallel/threads.hpp"

namespace tektite {
namespace {

void say(std::string_view text) {
  // Nothing is left to be done where standard error cannot be written.
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
}

/// Calls only what a signal handler may call.
void tell_and_end(int, siginfo_t* info, void*) {
  say("tektite-solve: error: ");
  say(info->si_code == FPE_FLTDIV   ? "a division by zero"
      : info->si_code == FPE_FLTOVF ? "an overflow"
                                    : "an undefined result (such as 0/0)");
  say(" of floating-point numbers; where, from the inside out:\n");
  void* frames[32];
  ::backtrace_symbols_fd(frames, ::backtrace(frames, 32), STDERR_FILENO);
  ::_exit(exit_failed);
}

}  // namespace

void trap_floating_point() {
  void* frame = nullptr;
  ::backtrace(&frame, 1);  // its first call allocates, which a signal handler must not
  struct sigaction action {};
  action.sa_sigaction = tell_and_end;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGFPE, &action, nullptr);
  on_every_thread([] {
    ::feclearexcept(FE_ALL_EXCEPT);  // of what has been computed before
    ::feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
  });
}

}  // namespace tektite
