// A run that is killed, or told to end, goes on as if nothing had been: history, snapshots and measures come out the
// same to the last bit.
#include <pty.h>

#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <sstream>

#include "core/snapshot.hpp"
#include "robustness/small_run.hpp"

namespace {

namespace fs = std::filesystem;
using namespace tektite::test;
using Catch::Matchers::Contains;

/// Every file that is called a particle file can be read.
void check_files(const std::string& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".h5") {
      INFO(entry.path());
      CHECK_NOTHROW(tektite::read_snapshot(entry.path().string()));
    }
}

/// What a killed run leaves of its history is the beginning of the unbroken one, but for a line that is cut.
void check_history(const std::string& folder, const std::string& unbroken) {
  const auto history = content_of(folder + "/history.csv");
  const auto whole_lines = history.substr(0, history.rfind('\n') + 1);
  CHECK(unbroken.substr(0, whole_lines.size()) == whole_lines);
}

/// Lines of the history that are there, and those of them that the newest snapshot does not need.
struct Survival {
  std::size_t kept = 0, ahead = 0;
};

Survival survival_of(const std::string& folder) {
  Survival survival;
  const auto snapshots = tektite::snapshot_files(folder);
  const auto last = snapshots.empty() ? -1 : std::stoll(fs::path(snapshots.back()).stem().string());
  std::istringstream lines(content_of(folder + "/history.csv"));
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line); ++survival.kept) survival.ahead += std::stoll(line) > last;
  return survival;
}

/// Kills a run when its history has come to some random length; sometimes before it has begun.
void kill_at_random(Started&& running, const std::string& history, std::size_t whole, std::mt19937& random) {
  const auto length = random() % (whole + whole / 10);
  const auto long_enough = [&] {
    std::error_code missing;
    const auto size = fs::file_size(history, missing);
    return !missing && size >= std::min(length, whole - 1);
  };
  if (length < whole) CHECK(comes_about(long_enough));
  std::this_thread::sleep_for(std::chrono::microseconds(random() % 10000));
  running.end_by(SIGKILL);
}

/// Kills runs of a scheme, resumes them and compares.
void kill_runs(const std::string& scheme, int kills, unsigned seed) {
  INFO("TEKTITE_SEED=" << seed << ", scheme " << scheme);
  const SmallRun small(scheme);
  const auto whole = small.unbroken();
  std::mt19937 random(seed);
  Survival sum;
  int early = 0;
  for (int k = 0; k < kills; ++k) {
    const auto run = "killed" + std::to_string(k);
    INFO(run);
    small.fill(run);
    auto words = small.solving(run);
    const int times = 1 + k % 2;  // every second run is killed again where it was resumed
    for (int n = 0; n < times; ++n) {
      kill_at_random(small.start(words), small.folder(run + "/history.csv"), whole.history.size(), random);
      check_files(small.folder(run));
      check_history(small.folder(run), whole.history);
      words = small.resuming(run);
    }
    const auto survival = survival_of(small.folder(run));
    early += survival.kept == 0;
    sum.kept += survival.kept;
    sum.ahead += survival.ahead;
    const auto outcome = small.program(small.resuming(run));
    INFO(outcome.faults);
    REQUIRE(outcome.code == 0);
    small.measure(run);
    const auto left = left_in(small.folder(run));
    CHECK(left.history == whole.history);
    CHECK(left.snapshots == whole.snapshots);
    CHECK((left.last_snapshot == whole.last_snapshot));
    CHECK(left.measurements == whole.measurements);
    fs::remove_all(small.folder(run));
  }
  std::cout << scheme << ", seed " << seed << ": " << kills << " runs killed, " << early
            << " of them before the first step; " << sum.kept << " lines of history survived, " << sum.ahead
            << " of them behind the newest snapshot" << std::endl;
}

TEST_CASE("Killed: a run of any scheme, killed at random moments, is resumed to the same end") {
  for (const auto& [scheme, settings] : schemes()) kill_runs(scheme, 1, seed());
}

TEST_CASE("Killed: two hundred runs are resumed to the same end", "[.long]") {
  constexpr int kills = 34;  // times six schemes
  for (const auto& [scheme, settings] : schemes()) kill_runs(scheme, kills, seed());
}

TEST_CASE("Killed: while a snapshot is written, the one before stays and nothing half written counts") {
  const std::size_t before = GENERATE(0, 3);  // the first is waited for; others are written while the run goes on
  const SmallRun small("eulerian");
  const auto whole = small.unbroken();
  small.fill("killed");
  auto running = small.start(small.solving("killed"));
  const auto half_written = [&] {
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(small.folder("killed/snapshots"), missing))
      if (entry.path().extension() == ".part") return true;
    return false;
  };
  const auto snapshots = [&] { return tektite::snapshot_files(small.folder("killed")).size(); };
  REQUIRE(comes_about([&] { return half_written() && snapshots() >= before; }));
  CHECK(running.end_by(SIGKILL) == -1);
  CHECK(snapshots() >= before);
  check_files(small.folder("killed"));
  check_history(small.folder("killed"), whole.history);
  REQUIRE(small.program(small.resuming("killed")).code == 0);
  CHECK_FALSE(half_written());
  small.measure("killed");
  CHECK((left_in(small.folder("killed")) == whole));
}

TEST_CASE("Killed: a front that is killed takes its solver with it, and the run is resumed by `tektite resume`") {
  const SmallRun small("eulerian");
  const auto whole = small.unbroken();
  auto running = small.start({TEKTITE_PROGRAM, "run", "scene.toml", "-o", "killed", "--threads", "1"});
  REQUIRE(comes_about([&] { return content_of(small.folder("killed/history.csv")).size() > 3000; }));
  CHECK(running.end_by(SIGKILL) == -1);
  // Its solver has been told to end; until it has, the folder is locked.
  Outcome resumed;
  REQUIRE(comes_about([&] {
    resumed = small.program({TEKTITE_PROGRAM, "resume", "killed", "--threads", "1"});
    return resumed.code != 2;
  }));
  INFO(resumed.output << resumed.faults);
  REQUIRE(resumed.code == 0);
  const auto left = left_in(small.folder("killed"));
  CHECK(left.history == whole.history);
  CHECK(left.snapshots == whole.snapshots);
  CHECK((left.last_snapshot == whole.last_snapshot));
  CHECK(left.measurements == whole.measurements);
}

TEST_CASE("Interrupted: SIGINT and SIGTERM end a run with a snapshot, from which it comes to the same end") {
  const int number = GENERATE(SIGINT, SIGTERM);
  INFO("signal " << number);
  const SmallRun small("eulerian");
  const auto whole = small.unbroken();
  small.fill("interrupted");
  auto running = small.start(small.solving("interrupted"));
  REQUIRE(comes_about([&] { return content_of(small.folder("interrupted/history.csv")).size() > 3000; }));
  CHECK(running.end_by(number) == 1);
  CHECK_THAT(content_of(small.folder("interrupted/run.log")), Contains("interrupted at t = "));
  const auto survival = survival_of(small.folder("interrupted"));
  CHECK(survival.kept > 10);
  CHECK(survival.ahead == 0);
  REQUIRE(small.program(small.resuming("interrupted")).code == 0);
  small.measure("interrupted");
  CHECK((left_in(small.folder("interrupted")) == whole));
}

/// The list of names in solve.json.
std::string warnings_of(const std::string& folder) {
  const auto summary = content_of(folder + "/solve.json");
  return summary.substr(std::min(summary.find("\"warnings\""), summary.size()));
}

TEST_CASE("Interrupted: what a run was warned of before, it is told of at its end too") {
  // The bar flies through the plate, and is out of it after 2.5 us: before the run is interrupted.
  const SmallRun small("total-lagrangian", {"contact.factor=1e-9", "body.bar.velocity=['10 km/s', 0]",
                                            "scheme.courant=0.02", "time.end=6 us"});
  const auto whole = small.unbroken();
  const auto told = warnings_of(small.folder("unbroken"));
  REQUIRE_THAT(told, Contains("interpenetration"));
  small.fill("interrupted");
  auto running = small.start(small.solving("interrupted"));
  REQUIRE(comes_about([&] { return tektite::snapshot_files(small.folder("interrupted")).size() >= 20; }));
  CHECK(running.end_by(SIGKILL) == -1);
  REQUIRE(small.program(small.resuming("interrupted")).code == 0);
  CHECK(warnings_of(small.folder("interrupted")) == told);
  CHECK((left_in(small.folder("interrupted")).last_snapshot == whole.last_snapshot));
}

/// What a run shows on a terminal until the end of the first text that begins with this one; then it is told to end.
std::string shown_up_to(const std::string& sought, const std::string& end, const std::string& folder,
                        std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  REQUIRE(child >= 0);
  if (child == 0) {
    if (::chdir(folder.c_str()) == 0) ::execv(arguments[0], arguments.data());
    ::_exit(127);
  }
  std::string shown;
  std::array<char, 4096> part;
  const auto is_there = [&] {
    const auto at = shown.find(sought);
    return at != std::string::npos && shown.find(end, at) != std::string::npos;
  };
  for (ssize_t count = 1; !is_there() && count > 0; shown.append(part.data(), static_cast<std::size_t>(count)))
    count = std::max<ssize_t>(::read(terminal, part.data(), part.size()), 0);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ::close(terminal);
  return shown;
}

TEST_CASE("Interrupted: before its first line of history a resumed run shows the drift of its snapshot") {
  const SmallRun small("eulerian", {"time.end=1", "output.history=1000000000"});
  small.fill("resumed");
  auto running = small.start(small.solving("resumed"));
  REQUIRE(comes_about([&] { return tektite::snapshot_files(small.folder("resumed")).size() >= 2; }));
  CHECK(running.end_by(SIGINT) == 1);
  const auto shown = shown_up_to("drift ", "%", small.path(), small.resuming("resumed"));
  INFO(shown);
  const auto at = shown.find("drift ");
  REQUIRE(at != std::string::npos);
  CHECK(std::abs(std::stod(shown.substr(at + 6))) < 5.0);  // per cent; an empty ledger has lost a hundred
}

TEST_CASE("Killed: a history that does not reach the snapshot is told, and not gone on with") {
  const SmallRun small("eulerian");
  small.unbroken();
  const auto path = small.folder("unbroken/history.csv");
  const auto history = content_of(path);
  const auto refused = [&](const std::string& reason) {
    const auto outcome = small.program(small.resuming("unbroken"));
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.faults, Contains("history.csv: " + reason));
    CHECK_THAT(outcome.faults, Contains("(allowed: the history of this run, whole; or `tektite run"));
  };
  std::ofstream(path, std::ios::binary) << history.substr(0, history.size() / 2);
  refused("the history ends at step");
  std::ofstream(path, std::ios::binary) << "step,time\n";
  refused("holds no step");
  fs::remove(path);
  refused("there is none that can be read");
}

/// The settings of a run that a condition stops long before its end.
const std::vector<std::string> stopped_runs{
    "stop_when.kinetic-energy-steady={during='0.3 us', tolerance=0.05}",
    "stop_when.reach={type='steady', column='front.position_x', during='0.2 us', tolerance=0.02}"};

TEST_CASE("Resume: a run goes on to another end, as if it had been that from the start; what came to its end stays") {
  const SmallRun small("eulerian");
  const auto unbroken = small.unbroken();
  const SmallRun shorter("eulerian", {"time.end=1.01 us"});
  shorter.fill("run");
  REQUIRE(shorter.program(shorter.solving("run")).code == 0);
  const auto to_the_end = [&](const std::string& end) {
    auto words = shorter.resuming("run");
    words.insert(words.end(), {"--end", end});
    return shorter.program(words);
  };

  const auto refused = to_the_end("0.5 us");
  CHECK(refused.code == 2);
  CHECK_THAT(refused.faults, Contains("--end 0.5 us") && Contains("t = 1.01"));
  CHECK_THAT(to_the_end("soon").faults, Contains("--end soon") && Contains("time.end"));

  const auto first_end = tektite::snapshot_files(shorter.folder("run")).back();
  SECTION("from its end") {
    CHECK(to_the_end("3 us").code == 0);
    CHECK(fs::exists(first_end));
    CHECK(tektite::read_snapshot(tektite::snapshot_files(shorter.folder("run")).back()).time() == Approx(3e-6));
    shorter.measure("run");
    CHECK_THAT(left_in(shorter.folder("run")).measurements, Contains("peak_pressure"));
  }
  SECTION("from before its end") {
    fs::remove(first_end);
    CHECK(to_the_end("3 us").code == 0);
    shorter.measure("run");
    CHECK(left_in(shorter.folder("run")).history == unbroken.history);
    CHECK(left_in(shorter.folder("run")).snapshots == unbroken.snapshots);
    CHECK(left_in(shorter.folder("run")).measurements == unbroken.measurements);
  }
}

TEST_CASE("Stopped: a condition ends a run at the same step on any number of threads and where it was killed before") {
  const auto condition = GENERATE(from_range(stopped_runs));
  INFO(condition);
  const SmallRun small("eulerian", {"time.end=30 us", "output.history=3",
                                    "probe.front={body='bar', extreme='largest', fields=['position']}", condition});
  const auto whole = small.unbroken();
  const auto told = content_of(small.folder("unbroken/solve.json"));
  CHECK_THAT(told, Contains("\"stopped_by\": \"" + condition.substr(10, condition.find('=') - 10) + ": "));
  CHECK_THAT(content_of(small.folder("unbroken/run.log")), Contains("stopped by "));
  CHECK_THAT(content_of(small.folder("unbroken/measurements.json")), Contains("\"stopped_by\""));
  small.fill("two");
  REQUIRE(small.program({stage_program("solve"), "two", "--threads", "2"}).code == 0);
  CHECK(left_in(small.folder("two")).history == whole.history);
  small.fill("killed");
  std::mt19937 random(seed());
  kill_at_random(small.start(small.solving("killed")), small.folder("killed/history.csv"), whole.history.size(),
                 random);
  REQUIRE(small.program(small.resuming("killed")).code == 0);
  REQUIRE(small.program(small.resuming("killed")).code == 0);  // it is over, and stays so
  small.measure("killed");
  CHECK(left_in(small.folder("killed")).history == whole.history);
  CHECK((left_in(small.folder("killed")).last_snapshot == whole.last_snapshot));
  CHECK(left_in(small.folder("killed")).measurements == whole.measurements);
}

}  // namespace
