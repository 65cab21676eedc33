// A disk that is full, a folder that cannot be written to.
#include <fcntl.h>
#include <sys/resource.h>

#include <catch2/catch.hpp>

#include "core/snapshot.hpp"
#include "robustness/small_run.hpp"

namespace {

namespace fs = std::filesystem;
using namespace tektite::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

/// No file can grow beyond the size that history.csv has in the midst of a run: as a disk that becomes full then.
constexpr rlim_t room = 45000;
void limit_room() {
  const rlimit limit{room, room};
  ::setrlimit(RLIMIT_FSIZE, &limit);
}

void let_output_fail() { ::dup2(::open("/dev/full", O_WRONLY), STDOUT_FILENO); }

TEST_CASE("Disk: where it becomes full the run ends with an error, keeps its last snapshot and is resumed") {
  const SmallRun small("eulerian", {"spacing=2 mm", "time.end=15 us", "output.snapshots=2 us"});
  const auto whole = small.unbroken();
  REQUIRE(whole.last_snapshot.size() < room);  // so that it is in the midst of the run that room ends
  REQUIRE(whole.history.size() > room);
  small.fill("full");
  const auto outcome = run_in(small.path(), small.solving("full"), limit_room);
  CHECK(outcome.code == 1);
  CHECK_THAT(outcome.faults,
             StartsWith("tektite-solve: error: full/history.csv: cannot be written (is the disk full?)") &&
                 Contains("the last good snapshot is full/snapshots/"));
  CHECK_THAT(outcome.output, !Contains("cannot be written"));
  CHECK_THAT(content_of(small.folder("full/run.log")), Contains("full/history.csv: cannot be written"));
  const auto snapshots = tektite::snapshot_files(small.folder("full"));
  REQUIRE(snapshots.size() > 1);
  CHECK_NOTHROW(tektite::read_snapshot(snapshots.back()));
  REQUIRE(small.program(small.resuming("full")).code == 0);
  small.measure("full");
  CHECK((left_in(small.folder("full")) == whole));
}

TEST_CASE("Disk: a snapshot for which there is no room is an error, and no half of it is left") {
  const SmallRun small("eulerian");
  small.fill("full");
  constexpr auto limit_to_less = [] {
    const rlimit limit{50000, 50000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  };
  const auto outcome = run_in(small.path(), small.solving("full"), limit_to_less);
  CHECK(outcome.code == 1);
  CHECK_THAT(outcome.faults, Contains("full/snapshots/000000.h5") && Contains("(is the disk full?)"));
  CHECK(std::distance(fs::directory_iterator(small.folder("full/snapshots")), fs::directory_iterator()) == 0);
  CHECK(small.program(small.resuming("full")).code == 0);
}

TEST_CASE("Disk: a snapshot that fails while the run goes on ends it, is told once, and the run is resumed") {
  const SmallRun small("eulerian", {"time.end=15 us"});
  const auto whole = small.unbroken();
  small.fill("run");
  const auto snapshots = small.folder("run/snapshots"), kept = small.folder("run/kept");
  std::ofstream(kept) << "in the way";
  // In the midst of the run the file takes the place of their folder, and the folder that of the file.
  const auto exchange = [&] {
    return ::renameat2(AT_FDCWD, snapshots.c_str(), AT_FDCWD, kept.c_str(), RENAME_EXCHANGE) == 0;
  };
  std::thread fault([&] {
    comes_about([&] { return tektite::snapshot_files(small.folder("run")).size() >= 3; });
    exchange();
  });
  const auto outcome = small.program(small.solving("run"));
  fault.join();
  INFO(outcome.faults);
  CHECK(outcome.code == 1);
  CHECK_THAT(outcome.faults, StartsWith("tektite-solve: error: run/snapshots") && Contains("cannot be"));
  CHECK(std::count(outcome.faults.begin(), outcome.faults.end(), '\n') == 2);
  CHECK_THAT(outcome.output, !Contains("cannot be"));
  CHECK_THAT(content_of(small.folder("run/run.log")), Contains("run/snapshots") && Contains("cannot be"));
  const std::string told = "the last good snapshot is run/snapshots/";
  const auto at = outcome.faults.find(told);
  REQUIRE(at != std::string::npos);
  const auto name = outcome.faults.substr(at + told.size(), std::string("000000.h5").size());
  CHECK_NOTHROW(tektite::read_snapshot(kept + "/" + name));
  REQUIRE(exchange());
  fs::remove(kept);
  REQUIRE(small.program(small.resuming("run")).code == 0);
  small.measure("run");
  CHECK((left_in(small.folder("run")) == whole));
}

/// Runs the small scene on a file system of its own that takes no more than this, has it resumed where there is room
/// and copies what is left then to `after`. The exit code is that of the run; 77 where nothing can be mounted.
Outcome run_on_small_disk(const SmallRun& small, std::uintmax_t bytes) {
  const std::string script = R"(
    mkdir -p disk && mount -t tmpfs -o size="$2" none disk || exit 77
    "$1" run scene.toml -o disk/run --threads 1
    code=$?
    find disk -name '*.part*'
    mount -o remount,size=100m disk && "$1" resume disk/run --threads 1 >/dev/null 2>&1 || exit 78
    rm -rf after && cp -r disk/run after
    exit $code)";
  return run_in(small.path(), {"/usr/bin/unshare", "--map-root-user", "--mount", "sh", "-c", script, "sh",
                               TEKTITE_PROGRAM, std::to_string(bytes)});
}

/// Bytes on the disk of the files below a folder, by whole pages.
std::uintmax_t room_of(const std::string& folder) {
  constexpr std::uintmax_t page = 4096;
  std::uintmax_t sum = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    sum += entry.is_regular_file() ? (entry.file_size() + page - 1) / page * page : page;
  return sum;
}

TEST_CASE("Disk: whichever stage a small one fills up in says so once, and the run goes on when there is room") {
  const SmallRun small("eulerian");
  const auto whole = small.unbroken();
  fs::remove_all(small.folder("unbroken/vtu"));
  const auto solved = room_of(small.folder("unbroken"));
  struct Case {
    std::uintmax_t bytes;
    std::string says;
  };
  constexpr std::uintmax_t some = 1 << 16;  // for less than the first files for ParaView
  for (const auto& [bytes, says] : std::vector<Case>{{solved / 2, "tektite-solve: error: disk/run/"},
                                                     {solved + some, "tektite-postprocess: error: disk/run/vtu/"}}) {
    const auto outcome = run_on_small_disk(small, bytes);
    if (outcome.code == 77) {
      WARN("no file system can be mounted here: " << outcome.faults);
      return;
    }
    INFO(outcome.faults);
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.faults, StartsWith(says) && Contains("cannot be"));
    const bool solving = outcome.faults.find("\n  the last good snapshot is disk/run/snapshots/") != std::string::npos;
    CHECK(std::count(outcome.faults.begin(), outcome.faults.end(), '\n') == (solving ? 2 : 1));
    CHECK(outcome.output.find(".part") == std::string::npos);
    CHECK((left_in(small.folder("after")) == whole));
  }
}

TEST_CASE("Disk: a log or an output that cannot be written is an error") {
  const SmallRun small("eulerian");
  small.fill("run");
  fs::create_symlink("/dev/full", small.folder("run/run.log"));
  const auto outcome = small.program(small.solving("run"));
  CHECK(outcome.code == 1);
  CHECK_THAT(outcome.faults, Contains("run/run.log: cannot be written"));

  const auto unheard = run_in(small.path(), {TEKTITE_PROGRAM, "help"}, let_output_fail);
  CHECK(unheard.code == 1);
  CHECK_THAT(unheard.faults, Contains("standard output cannot be written"));
}

TEST_CASE("Disk: a folder in place of the log, and a history that is gone, are errors") {
  const SmallRun small("eulerian", {"time.end=1 us", "output.snapshots=1 us"});
  small.fill("run");
  fs::create_directory(small.folder("run/run.log"));
  const auto unlogged = small.program(small.solving("run"));
  CHECK(unlogged.code == 1);
  CHECK_THAT(unlogged.faults, StartsWith("tektite-solve: error: run/run.log: the log cannot be opened: "));
  fs::remove(small.folder("run/run.log"));
  REQUIRE(small.program(small.solving("run")).code == 0);
  fs::remove(small.folder("run/history.csv"));
  const auto resumed = small.program(small.resuming("run"));
  CHECK(resumed.code == 2);
  CHECK_THAT(resumed.faults, StartsWith("tektite-solve: error: run/history.csv: there is none that can be read"));
}

TEST_CASE("Disk: a folder that cannot be made or written to is an error before anything is computed") {
  const SmallRun small("eulerian");
  std::ofstream(small.folder("file")) << "in the way";
  // No rights bind who runs tests as root, but nobody makes a folder in /proc.
  const auto [folder, code] = GENERATE(table<std::string, int>({{"file", 2}, {"file/below", 1}, {"/proc/tektite", 1}}));
  const auto outcome = small.program({TEKTITE_PROGRAM, "run", "scene.toml", "-o", folder});
  INFO(outcome.faults);
  CHECK(outcome.code == code);
  CHECK_THAT(outcome.faults, StartsWith("tektite: error: " + folder + ": "));
  CHECK(std::count(outcome.faults.begin(), outcome.faults.end(), '\n') == 1);
}

TEST_CASE("Disk: files in place of the folders of a run are errors of the stage that needs them") {
  const SmallRun small("eulerian");
  small.unbroken();
  small.fill("run");
  std::ofstream(small.folder("run/snapshots")) << "in the way";
  const auto solved = small.program(small.solving("run"));
  CHECK(solved.code == 1);
  CHECK_THAT(solved.faults, Contains("run/snapshots") && Contains("cannot be"));
  fs::remove_all(small.folder("unbroken/vtu"));
  std::ofstream(small.folder("unbroken/vtu")) << "in the way";
  const auto measured = small.program({stage_program("postprocess"), "unbroken", "--no-pictures"});
  CHECK(measured.code == 1);
  CHECK_THAT(measured.faults, Contains("unbroken/vtu"));
  fs::remove(small.folder("unbroken/vtu"));
  fs::create_directories(small.folder("unbroken/vtu/000000.vtu.part"));
  const auto one_file = small.program({stage_program("postprocess"), "unbroken", "--no-pictures"});
  CHECK(one_file.code == 1);
  CHECK_THAT(one_file.faults, StartsWith("tektite-postprocess: error: unbroken/vtu/000000.vtu: cannot be written: "));
  CHECK(std::count(one_file.faults.begin(), one_file.faults.end(), '\n') == 1);
  const auto elsewhere = small.program({stage_program("postprocess"), "unbroken", "--no-pictures", "-o", "/proc/none"});
  CHECK(elsewhere.code == 1);
  CHECK_THAT(elsewhere.faults, Contains("/proc/none"));
}

}  // namespace
