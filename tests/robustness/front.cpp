// The front as a user meets it: its commands, a whole run, a second one, and Ctrl-C.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "robustness/small_run.hpp"
#include "support/apart.hpp"
#include "support/program.hpp"

namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using tektite::test::content_of;
using tektite::test::run_in;
using tektite::test::SmallRun;
using tektite::test::stage_program;
using tektite::test::TemporaryFolder;

/// A folder with the small scene of the wrong scenes and a published value.
struct Workplace {
  Workplace() {
    fs::copy(std::string(WRONG_SCENES) + "/base.toml", folder.file("scene.toml"));
    std::ofstream(folder.file("reference.toml")) << "[[reference]]\nmeasure = \"peak_pressure\"\nvariant = \"fast\"\n"
                                                    "published = \"50 GPa\"\nsource = \"a value to compare with\"\n";
  }
  tektite::test::Outcome tektite(std::vector<std::string> words) const {
    words.insert(words.begin(), TEKTITE_PROGRAM);
    return run_in(folder.path(), words);
  }
  bool has(const std::string& file) const { return fs::exists(folder.file(file)); }
  TemporaryFolder folder;
};

TEST_CASE("Front: help and version are given for it and for every command") {
  const Workplace place;
  CHECK(place.tektite({"--version"}).output == "tektite " TEKTITE_VERSION "\n");
  for (const std::string command :
       {"run", "check", "resume", "chart", "report", "preprocess", "solve", "postprocess"}) {
    INFO(command);
    CHECK_THAT(place.tektite({"help"}).output, Contains("\n  " + command + " "));
    const auto help = place.tektite({command, "--help"});
    CHECK(help.code == 0);
    CHECK_THAT(help.output, Catch::StartsWith("Usage: tektite"));
    CHECK(place.tektite({"help", command}).output == help.output);
    CHECK(place.tektite({command, "--version"}).output == "tektite " TEKTITE_VERSION "\n");
  }
}

TEST_CASE("Front: an unknown command is answered with the known ones") {
  const Workplace place;
  const auto outcome = place.tektite({"compute", "scene.toml"});
  CHECK(outcome.code == 2);
  CHECK_THAT(outcome.faults, Contains("\"compute\"") && Contains("allowed: run, check, resume"));
  CHECK(place.tektite({}).code == 2);
}

TEST_CASE("Front: what a command line lacks, and what is too much in it, is told") {
  const Workplace place;
  struct Wrong {
    std::vector<std::string> words;
    std::string says;
  };
  const std::vector<Wrong> table{
      {{}, "no command is given"},
      {{"run"}, "SCENE.toml is missing"},
      {{"run", "scene.toml", "--threads", "many"}, "see --help"},
      {{"chart", "study.toml", "--threads", "0"}, "--threads must be at least 1"},
      {{"chart", "study.toml", "--jobs", "0"}, "--jobs must be at least 1"},
      {{"preprocess"}, "no scene is given"},
      {{"preprocess", "scene.toml"}, "either -o FILE.h5 or --check"},
      {{"preprocess", "scene.toml", "--check", "--threads", "0"}, "--threads must be at least 1"},
      {{"preprocess", "scene.toml", "--check", "--most-particles", "0"}, "--most-particles must be at least 1"},
      {{"solve"}, "the folder of the run is missing"},
      {{"solve", ".", "--threads", "5000"}, "--threads must be a number from 0 to 4096"},
      {{"postprocess"}, "nothing to do"},
      {{"postprocess", "--chart", "study.toml"}, "--chart needs the folder"},
      {{"postprocess", "--page", "one"}, "--page needs the file"},
      {{"postprocess", "one", "two"}, "one folder at a time"},
      {{"postprocess", "--stability", "study.toml"}, "--stability needs the folder"},
      {{"postprocess", "nowhere"}, "there is no such folder or file"},
      {{"solve", "--stability", "study.toml"}, "--stability needs the folder"},
      {{"solve", "nowhere"}, "there is no such folder"},
      {{"solve", ".", "--resume"}, "there is no snapshot to go on from"},
      {{"resume", "nowhere"}, "there is no such folder"},
      {{"resume", "."}, "there is no snapshot to go on from"},
      {{"compute"}, "unknown command \"compute\""},
  };
  for (const auto& wrong : table) {
    const auto outcome = place.tektite(wrong.words);
    INFO(wrong.says << ": " << outcome.faults);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.faults, Contains(wrong.says));
  }
}

TEST_CASE("Front: a stage that was not built is told") {
  const Workplace place;
  fs::copy(TEKTITE_PROGRAM, place.folder.file("alone"));
  const auto outcome = run_in(place.folder.path(), {place.folder.file("alone"), "solve", "."});
  CHECK(outcome.code == 1);
  CHECK_THAT(outcome.faults, Contains("tektite-solve: this program is not there"));
}

/// The front in a folder of its own, in place of whose stages stands a script.
struct Alone {
  explicit Alone(const std::string& script) {
    fs::copy(TEKTITE_PROGRAM, place.folder.file("tektite"));
    for (const std::string stage : {"preprocess", "solve", "postprocess"}) {
      const auto path = place.folder.file("tektite-" + stage);
      std::ofstream(path) << script;
      fs::permissions(path, fs::perms::all);
    }
    fs::permissions(place.folder.path(), fs::perms::all);  // for who is not root any more
  }
  std::string check(void (*prepare)() = [] {}) const {
    const auto outcome = run_in(place.folder.path(), {place.folder.file("tektite"), "check", "scene.toml"}, prepare);
    CHECK(outcome.code == 1);
    return outcome.faults;
  }
  Workplace place;
};

TEST_CASE("Front: a stage that is killed, that cannot be started, or that a signal outlives, is told") {
  CHECK_THAT(Alone("#!/bin/sh\nkill -KILL $$\n").check(),
             Contains("tektite-preprocess was ended by signal 9 (Killed): so the system does where memory runs out"));
  CHECK_THAT(Alone("#!/bin/sh\ntrap '' INT\nkill -INT $PPID\nexit 0\n").check(),
             Contains("interrupted in tektite-preprocess"));
  CHECK_THAT(Alone("#!/no/such/interpreter\n").check(),
             Contains("tektite-preprocess: cannot be started: No such file or directory"));
  CHECK_THAT(Alone("#!/bin/sh\nexit 0\n").check(tektite::test::allow_no_process),
             Contains("tektite-preprocess: cannot be started: Resource temporarily unavailable"));
  const Alone alone("#!/no/such/interpreter\n");
  const auto become = run_in(alone.place.folder.path(), {alone.place.folder.file("tektite"), "solve", "."});
  CHECK(become.code == 1);
  CHECK_THAT(become.faults, Contains("tektite-solve: cannot be started: No such file or directory"));
}

TEST_CASE("Front: where nothing can be laid aside for a check, that is told") {
  const Alone alone("#!/bin/sh\nexit 0\n");
  CHECK_THAT(alone.check([] { ::setenv("TMPDIR", "/proc", 1); }),
             Contains("/proc/tektite-check-") && Contains("this folder cannot be made: "));
  CHECK_THAT(alone.check([] { ::setenv("TMPDIR", "/no/such/folder", 1); }),
             Contains("TMPDIR: there is no folder for what is checked: "));
}

TEST_CASE("Front: who starts it may ignore children, and they are waited for all the same") {
  const Workplace place;
  const auto outcome =
      run_in(place.folder.path(), {TEKTITE_PROGRAM, "check", "scene.toml"}, [] { ::signal(SIGCHLD, SIG_IGN); });
  INFO(outcome.faults);
  CHECK(outcome.code == 0);
}

TEST_CASE("Front: threads that are bound to processors are as many as others") {
  const SmallRun small("eulerian", {"spacing=0.5 mm", "time.end=0.01 us"});
  small.fill("run");
  const auto begun = [&](void (*prepare)()) {
    const auto outcome = run_in(small.path(), {stage_program("solve"), "run"}, prepare);
    CHECK(outcome.code == 0);
    return outcome.output.substr(0, outcome.output.find('\n'));
  };
  const auto free = begun([] {});
  CHECK_THAT(free, Contains(" threads: started from "));
  CHECK(begun([] { ::setenv("OMP_PROC_BIND", "true", 1); }) == free);
  CHECK(begun([] { ::setenv("OMP_PLACES", "cores", 1); }) == free);
}

TEST_CASE("Front: a run leaves its state, numbers and the table of ours beside published") {
  const Workplace place;
  const auto outcome = place.tektite({"run", "scene.toml", "--variant", "fast", "--threads", "1"});
  INFO(outcome.faults);
  REQUIRE(outcome.code == 0);
  CHECK_THAT(outcome.output, Contains("50 GPa") && Contains("a value to compare with"));
  CHECK_THAT(place.tektite({"postprocess", "runs/small-fast", "--set", "time.end=1"}).faults,
             Contains("--set changes a scene file"));
  for (const std::string part :
       {"particles.h5", "snapshots", "history.csv", "solve.json", "run.log", "measurements.json", "vtu", "small.pvd"}) {
    INFO(part);
    CHECK(place.has("runs/small-fast/" + part));
  }
  CHECK_THAT(content_of(place.folder.file("runs/small-fast/measurements.json")), Contains("\"fast\""));

  SECTION("a second run does not overwrite it unasked") {
    const auto again = place.tektite({"run", "scene.toml", "--variant", "fast"});
    CHECK(again.code == 2);
    CHECK_THAT(again.faults, Contains("runs/small-fast") && Contains("holds a run already") && Contains("--replace"));
    std::ofstream(place.folder.file("runs/small-fast/report.html")) << "a page about the first run";
    CHECK(place.tektite({"run", "scene.toml", "--variant", "fast", "--replace"}).code == 0);
    CHECK_FALSE(place.has("runs/small-fast/report.html"));
  }
  SECTION("a wrong scene leaves it as it was") {
    const auto before = content_of(place.folder.file("runs/small-fast/history.csv"));
    const auto wrong = place.tektite({"run", "scene.toml", "--variant", "fast", "--replace", "--set", "time.end=-1"});
    CHECK(wrong.code == 2);
    CHECK(content_of(place.folder.file("runs/small-fast/history.csv")) == before);
  }
  SECTION("to resume it when it is over changes nothing and measures again") {
    const auto before = content_of(place.folder.file("runs/small-fast/history.csv"));
    const auto resumed = place.tektite({"resume", "runs/small-fast"});
    INFO(resumed.faults);
    CHECK(resumed.code == 0);
    CHECK_THAT(resumed.output, Contains("a value to compare with"));
    CHECK(content_of(place.folder.file("runs/small-fast/history.csv")) == before);
  }
}

TEST_CASE("Front: a run in the folder of its scene takes away nothing of what is there") {
  const Workplace place;
  const auto reference = content_of(place.folder.file("reference.toml"));
  fs::create_directory(place.folder.file("pictures"));
  std::ofstream(place.folder.file("pictures/of_mine.png")) << "not of the run";
  const auto outcome = place.tektite({"run", "scene.toml", "--variant", "fast", "-o", ".", "--threads", "1"});
  INFO(outcome.faults);
  REQUIRE(outcome.code == 0);
  CHECK_THAT(outcome.output, Contains("a value to compare with"));
  CHECK(content_of(place.folder.file("reference.toml")) == reference);
  CHECK(place.has("pictures/of_mine.png"));
  CHECK(place.has("history.csv"));
}

TEST_CASE("Front: published values of another scene, where no run is, are left as they are") {
  const Workplace place;
  fs::create_directory(place.folder.file("other"));
  std::ofstream(place.folder.file("other/reference.toml")) << "# values that took an afternoon\n";
  // A run that was killed as it began leaves a copy.
  fs::create_directory(place.folder.file("begun"));
  fs::copy(place.folder.file("reference.toml"), place.folder.file("begun/reference.toml"));
  CHECK(place.tektite({"run", "scene.toml", "-o", "begun", "--no-pictures"}).code == 0);
  for (const bool with_values : {true, false}) {
    if (!with_values) fs::remove(place.folder.file("reference.toml"));
    const auto outcome = place.tektite({"run", "scene.toml", "-o", "other"});
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.faults, Contains("other/reference.toml: is there, of no run and of another scene"));
    CHECK(content_of(place.folder.file("other/reference.toml")) == "# values that took an afternoon\n");
  }
}

TEST_CASE("Front: Ctrl-C ends a run with a snapshot from which it resumes") {
  const Workplace place;
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    ::setpgid(0, 0);  // a group of its own, as a terminal gives to what is run in it
    if (::chdir(place.folder.path().c_str()) != 0 || !std::freopen("/dev/null", "w", stdout) ||
        !std::freopen("/dev/null", "w", stderr))
      ::_exit(127);
    ::execl(TEKTITE_PROGRAM, TEKTITE_PROGRAM, "run", "scene.toml", "-o", "out", "--set", "time.end=1 s", nullptr);
    ::_exit(127);
  }
  ::setpgid(child, child);
  // The run would take a second of impact, hours of computing; it is under way once history.csv has grown.
  const auto history = place.folder.file("out/history.csv");
  constexpr int most_waits = 600;
  for (int wait = 0; wait < most_waits && content_of(history).size() < 2000; ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  ::kill(-child, SIGINT);
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 1);
  CHECK_FALSE(place.has("out/measurements.json"));
  const auto snapshots =
      std::distance(fs::directory_iterator(place.folder.file("out/snapshots")), fs::directory_iterator());
  CHECK(snapshots >= 2);
}

}  // namespace
