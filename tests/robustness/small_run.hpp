#pragma once
// A small impact by any scheme, as files that the real programs work on.

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/snapshot_files.hpp"
#include "support/program.hpp"

namespace tektite::test {

/// Of what is random in a test: another one each time, unless TEKTITE_SEED gives it.
inline unsigned seed() {
  const char* given = std::getenv("TEKTITE_SEED");
  return given ? static_cast<unsigned>(std::strtoul(given, nullptr, 10)) : std::random_device{}();
}

/// The programs of the stages, for what the front does not offer.
inline std::string stage_program(const std::string& stage) { return std::string(TEKTITE_PROGRAM) + "-" + stage; }

/// What each scheme needs of a scene, by name.
inline const std::map<std::string, std::string>& schemes() {
  static const std::string contact = "contact.model = 'kernel-penalty'\n";
  static const std::map<std::string, std::string> table{
      {"eulerian", "scheme.type = 'eulerian'\n"},
      {"total-lagrangian", contact + "scheme.type = 'total-lagrangian'\n"},
      {"adaptle", contact + "scheme = { type = 'adaptle', conversion = 'strain', conversion_strain = 0.1 }\n"},
      {"msph", "scheme.type = 'msph'\nsmoothing.kernel = 'truncated-gaussian'\n"},
      {"godunov-pm", "scheme.type = 'godunov-pm'\n"},
      {"godunov-split", "scheme.type = 'godunov-split'\n"}};
  return table;
}

/// What bodies of small scenes are made of.
inline const std::string small_material = R"(
[material.aluminium]
density = "2785 kg/m3"
eos = { model = "stiffened-gas", bulk_sound_speed = "5328 m/s", grueneisen = 2.0 }
strength = { model = "perfectly-plastic", shear_modulus = "27.6 GPa", yield_stress = "0.3 GPa" }
)";

/// A bar strikes a plate. Some hundred steps, with a snapshot every few of them.
inline std::string small_scene(const std::string& scheme) {
  return "name = 'small'\nspace = 'plane-strain'\nspacing = '1 mm'\n" + schemes().at(scheme) + small_material + R"(
[body.bar]
material = "aluminium"
shape = { type = "rectangle", lower = ["-16.5 mm", "-5 mm"], upper = ["-0.5 mm", "5 mm"] }
velocity = ["800 m/s", 0]

[body.plate]
material = "aluminium"
shape = { type = "rectangle", lower = ["0.5 mm", "-15 mm"], upper = ["8.5 mm", "15 mm"] }

[time]
end = "3 us"

[output]
snapshots = "0.15 us"

[probe.centre]
body = "bar"
position = ["-5 mm", 0]

[measure.peak_pressure]
probe = "centre"

[measure.clumping_time]
body = "bar"
ratio = 0.999

[picture.pressure]
field = "pressure"
)";
}

/// A program that runs beside the test, silently; ended with it.
class Started {
 public:
  Started(const std::string& folder, std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (auto& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    child_ = ::fork();
    if (child_ < 0) throw std::runtime_error("no process can be started");
    if (child_ == 0) {
      const int nowhere = ::open("/dev/null", O_WRONLY);
      ::dup2(nowhere, STDOUT_FILENO);
      ::dup2(nowhere, STDERR_FILENO);
      if (::chdir(folder.c_str()) == 0) ::execv(arguments[0], arguments.data());
      ::_exit(127);
    }
  }
  ~Started() {
    if (child_ > 0) end_by(SIGKILL);
  }
  Started(const Started&) = delete;
  Started& operator=(const Started&) = delete;

  bool has_ended() const {
    siginfo_t info{};
    return ::waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == child_;
  }
  pid_t process() const { return child_; }
  void signal(int number) const { ::kill(child_, number); }
  /// The exit code, or -1 where a signal ended it.
  int wait() {
    int status = 0;
    while (::waitpid(child_, &status, 0) < 0)
      if (errno != EINTR) throw std::runtime_error("a program cannot be waited for");
    child_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  int end_by(int number) {
    signal(number);
    return wait();
  }

 private:
  pid_t child_ = 0;
};

/// Waits until something has come about; false where it has not in five minutes.
template <class Condition>
bool comes_about(const Condition& condition) {
  for (const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(5);
       std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(std::chrono::microseconds(200)))
    if (condition()) return true;
  return false;
}

/// What a run leaves: everything that does not tell of times and machines.
struct Left {
  std::string history;
  std::string last_snapshot;
  std::vector<std::string> snapshots;  ///< names
  std::string measurements;
  bool operator==(const Left&) const = default;
};

/// measurements.json up to what belongs to the run and not to the impact.
inline std::string measured(const std::string& json) {
  return json.substr(std::min(json.find("\"measurements\""), json.size()));
}

inline Left left_in(const std::string& folder) {
  Left left;
  left.history = content_of(folder + "/history.csv");
  left.snapshots = snapshot_files(folder);
  if (!left.snapshots.empty()) left.last_snapshot = content_of(left.snapshots.back());
  for (auto& path : left.snapshots) path = std::filesystem::path(path).filename().string();
  left.measurements = measured(content_of(folder + "/measurements.json"));
  return left;
}

/// A folder with the small scene; runs lie in folders below it.
class SmallRun {
 public:
  /// `settings` are laid over the scene, as KEY=VALUE.
  explicit SmallRun(const std::string& scheme, std::vector<std::string> settings = {})
      : settings_(std::move(settings)) {
    std::ofstream(place_.file("scene.toml")) << small_scene(scheme);
  }

  std::string folder(const std::string& run) const { return place_.file(run); }
  const std::string& path() const { return place_.path(); }
  Outcome program(std::vector<std::string> words) const { return run_in(place_.path(), std::move(words)); }
  Started start(std::vector<std::string> words) const { return Started(place_.path(), std::move(words)); }

  /// Fills RUN/particles.h5.
  void fill(const std::string& run) const {
    std::filesystem::create_directories(folder(run));
    std::vector<std::string> words{stage_program("preprocess"), "scene.toml", "-o", run + "/particles.h5"};
    for (const auto& setting : settings_) words.insert(words.end(), {"--set", setting});
    check(program(words));
  }
  std::vector<std::string> solving(const std::string& run) const {
    return {stage_program("solve"), run, "--threads", "1"};
  }
  std::vector<std::string> resuming(const std::string& run) const {
    return {stage_program("solve"), run, "--threads", "1", "--resume"};
  }
  /// Measures, without pictures, which take most of the time.
  void measure(const std::string& run) const { check(program({stage_program("postprocess"), run, "--no-pictures"})); }
  /// The run that nothing disturbs.
  Left unbroken() const {
    fill("unbroken");
    check(program(solving("unbroken")));
    measure("unbroken");
    return left_in(folder("unbroken"));
  }

 private:
  static void check(const Outcome& outcome) {
    if (outcome.code != 0) throw std::runtime_error(outcome.output + outcome.faults);
  }
  TemporaryFolder place_;
  std::vector<std::string> settings_;
};

}  // namespace tektite::test
