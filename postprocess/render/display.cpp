#include "postprocess/render/display.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <string>

#include "core/error.hpp"
#include "core/system_words.hpp"

namespace tektite {
namespace {

constexpr const char* advice = "the X server Xvfb (Debian package xvfb) could not be started";

/// In the child: becomes Xvfb, which writes the number of its display to `report` and ends with this program.
[[noreturn]] void become_server(int report, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
  const int nowhere = open("/dev/null", O_RDWR);
  dup2(nowhere, STDIN_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  const auto number = std::to_string(report);
  // Between two pictures nobody is connected: a server that then resets itself may turn the next one away.
  execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1280x1024x24", "-nolisten", "tcp", "-noreset",
         static_cast<char*>(nullptr));
  _exit(127);
}

/// The display's number, or nothing where the server ended or said nothing in time.
std::string read_number(int report) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::seconds(30);
  std::string number;
  while (number.find('\n') == std::string::npos) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    pollfd waiting{report, POLLIN, 0};
    if (left <= 0 || poll(&waiting, 1, static_cast<int>(left)) <= 0) return {};
    std::array<char, 16> buffer;
    const auto count = read(report, buffer.data(), buffer.size());
    if (count <= 0) return {};
    number.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return number.substr(0, number.find('\n'));
}

void stop(pid_t server) {
  kill(server, SIGTERM);
  waitpid(server, nullptr, 0);
}

}  // namespace

PrivateDisplay::PrivateDisplay() {
  std::array<int, 2> ends;
  if (pipe(ends.data()) != 0) throw RunError(fmt::format("{}: {}", advice, words_for_error(errno)));
  const auto parent = getpid();
  server_ = fork();
  if (server_ == 0) {
    close(ends[0]);
    become_server(ends[1], parent);
  }
  close(ends[1]);
  const auto number = server_ > 0 ? read_number(ends[0]) : std::string();
  close(ends[0]);
  if (number.empty()) {
    if (server_ > 0) stop(server_);
    throw RunError(advice);
  }
  setenv("DISPLAY", (":" + number).c_str(), 1);  // NOLINT(concurrency-mt-unsafe): nothing else runs yet
}

PrivateDisplay::~PrivateDisplay() { stop(server_); }

}  // namespace tektite
