#include "front/stage.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include "core/error.hpp"
#include "core/program.hpp"
#include "core/system_words.hpp"
#include "core/wait_for.hpp"
#include "front/held_signals.hpp"

namespace tektite::front {
namespace {

// What a signal handler may touch.
volatile std::sig_atomic_t child_running = 0;
volatile std::sig_atomic_t signal_received = 0;

void note_signal(int signal) {
  signal_received = signal;
  if (child_running > 0) ::kill(static_cast<pid_t>(child_running), signal);
}

/// While it lives, SIGINT and SIGTERM are noted and do not end this program.
class Outliving {
 public:
  Outliving() {
    struct sigaction action {};
    action.sa_handler = note_signal;
    ::sigaction(SIGINT, &action, &interrupt_before_);
    ::sigaction(SIGTERM, &action, &terminate_before_);
  }
  ~Outliving() {
    ::sigaction(SIGINT, &interrupt_before_, nullptr);
    ::sigaction(SIGTERM, &terminate_before_, nullptr);
  }
  Outliving(const Outliving&) = delete;
  Outliving& operator=(const Outliving&) = delete;

 private:
  struct sigaction interrupt_before_ {};
  struct sigaction terminate_before_ {};
};

std::string path_of(Stage stage) {
  const auto path = std::filesystem::read_symlink("/proc/self/exe").parent_path() / program_of(stage);
  if (::access(path.c_str(), X_OK) != 0)
    throw RunError(path.string() + ": this program is not there; tektite was built without this stage");
  return path.string();
}

/// The argument vector of exec; points into `words`.
std::vector<char*> argument_vector(Words& words) {
  std::vector<char*> vector;
  for (auto& word : words) vector.push_back(word.data());
  vector.push_back(nullptr);
  return vector;
}

Words with_program(const std::string& path, const Words& arguments) {
  Words words{path};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

/// Leads a stream of the child to a file, where there is one.
void lead(int stream, const std::string& file) {
  if (file.empty()) return;
  const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (opened < 0 || ::dup2(opened, stream) < 0) ::_exit(exit_failed);
}

/// The child on its way to be the program: as a program of its own it starts with the usual signals, and it is told to
/// end where the front is killed.
[[noreturn]] void become(char* const* words, const Streams& streams, const sigset_t& mask, pid_t front) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != front) ::_exit(exit_failed);
  for (const int signal : {SIGINT, SIGTERM, SIGCHLD}) ::signal(signal, SIG_DFL);
  ::pthread_sigmask(SIG_SETMASK, &mask, nullptr);
  lead(STDOUT_FILENO, streams.output);
  lead(STDERR_FILENO, streams.faults);
  ::execvp(words[0], words);
  fmt::print(stderr, "tektite: error: {}: cannot be started: {}\n", words[0], words_for_error(errno));
  ::_exit(exit_failed);
}

/// Starts a child; a signal that comes while it starts waits until the child is known.
pid_t start(const std::string& path, const Words& arguments, Show show) {
  const HeldSignals signals({SIGINT, SIGTERM});
  const auto child = spawn(path, arguments, {show == Show::nothing ? "/dev/null" : "", ""}, signals.before());
  child_running = child;
  return child;
}

}  // namespace

std::string program_of(Stage stage) {
  switch (stage) {
    case Stage::preprocess:
      return "tektite-preprocess";
    case Stage::solve:
      return "tektite-solve";
    case Stage::postprocess:
      return "tektite-postprocess";
  }
  return {};
}

pid_t spawn(const std::string& path, const Words& arguments, const Streams& streams, const sigset_t& mask) {
  auto words = with_program(path, arguments);
  const auto vector = argument_vector(words);
  const pid_t front = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) become(vector.data(), streams, mask, front);
  if (child < 0) throw RunError(fmt::format("{}: cannot be started: {}", path, words_for_error(errno)));
  return child;
}

int run_stage(Stage stage, const Words& arguments, Show show) {
  const Outliving outliving;
  std::fflush(stdout);
  const pid_t child = start(path_of(stage), arguments, show);
  const int status = wait_for(child, program_of(stage));
  child_running = 0;
  if (WIFSIGNALED(status))
    throw RunError(fmt::format("{} was ended by signal {} ({}){}", program_of(stage), WTERMSIG(status),
                               words_for_signal(WTERMSIG(status)),
                               WTERMSIG(status) == SIGKILL ? ": so the system does where memory runs out, and fewer "
                                                             "particles need less (a larger spacing, symmetry planes)"
                                                           : ""));
  const int code = WEXITSTATUS(status);
  if (code == 0 && signal_received != 0) throw RunError(fmt::format("interrupted in {}", program_of(stage)));
  return code;
}

void become_stage(Stage stage, const Words& arguments) {
  const auto path = path_of(stage);
  auto words = with_program(path, arguments);
  std::fflush(stdout);
  ::execv(path.c_str(), argument_vector(words).data());
  throw RunError(fmt::format("{}: cannot be started: {}", path, words_for_error(errno)));
}

}  // namespace tektite::front
