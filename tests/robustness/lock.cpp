// One run at a time in a folder.
#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/run_lock.hpp"
#include "robustness/small_run.hpp"

namespace {

namespace fs = std::filesystem;
using namespace tektite::test;
using Catch::Matchers::Contains;

TEST_CASE("Lock: a second run in the same folder is refused, by whatever program, and the first one goes on") {
  const SmallRun small("eulerian");
  auto first = small.start({TEKTITE_PROGRAM, "run", "scene.toml", "-o", "out", "--threads", "1", "--set",
                            "time.end=1 s", "--set", "output.snapshots=1 s"});
  const auto history = [&] { return content_of(small.folder("out/history.csv")); };
  REQUIRE(comes_about([&] { return history().size() > 2000; }));
  const std::vector<std::vector<std::string>> others{{TEKTITE_PROGRAM, "run", "scene.toml", "-o", "out", "--replace"},
                                                     {TEKTITE_PROGRAM, "resume", "out"},
                                                     {TEKTITE_PROGRAM, "solve", "out"},
                                                     {stage_program("solve"), "out", "--resume"}};
  for (const auto& words : others) {
    const auto outcome = small.program(words);
    INFO(words[0] << " " << words[1]);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.faults, Contains("out: another run is at work in this folder"));
  }
  const auto before = history();
  CHECK(comes_about([&] { return history().size() > before.size(); }));
  CHECK(history().substr(0, before.size()) == before);
  CHECK(first.end_by(SIGTERM) == 1);
  CHECK_FALSE(fs::exists(small.folder("out/run.lock")));
}

TEST_CASE("Lock: a second chart in the same folder is refused") {
  const SmallRun small("eulerian");
  std::ofstream(small.folder("study.toml")) << "name = 'study'\nscene = 'scene.toml'\nresolutions = [{ factor = 1 }]\n"
                                               "[[error]]\nmeasure = 'energy_drift'\n[line.one]\n";
  const tektite::RunLock lock(small.folder("out"));
  const auto outcome = small.program({TEKTITE_PROGRAM, "chart", "study.toml", "-o", "out"});
  CHECK(outcome.code == 2);
  CHECK_THAT(outcome.faults, Contains("out: another run is at work in this folder"));
}

TEST_CASE("Lock: two runs that begin at the same moment: one comes to its end, the other is refused") {
  const SmallRun small("eulerian");
  const auto begin = [&] {
    return small.start({TEKTITE_PROGRAM, "run", "scene.toml", "-o", "out", "--threads", "1", "--set", "time.end=1 s"});
  };
  auto one = begin();
  auto other = begin();
  REQUIRE(comes_about([&] { return one.has_ended() || other.has_ended(); }));
  REQUIRE(comes_about([&] { return content_of(small.folder("out/history.csv")).size() > 2000; }));
  const std::vector<int> codes{one.end_by(SIGTERM), other.end_by(SIGTERM)};
  CHECK_THAT(codes, Catch::UnorderedEquals(std::vector<int>{1, 2}));
}

TEST_CASE("Lock: it is given back by whoever was killed, and its file taken away by whoever ended") {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const tektite::RunLock lock(folder.path());
    ::raise(SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  CHECK(fs::exists(folder.file("run.lock")));
  { const tektite::RunLock lock(folder.path()); }
  CHECK_FALSE(fs::exists(folder.file("run.lock")));
}

TEST_CASE("Lock: a folder that was made for it and stays empty goes with it") {
  const TemporaryFolder folder;
  { const tektite::RunLock lock(folder.file("new")); }
  CHECK_FALSE(fs::exists(folder.file("new")));
  {
    const tektite::RunLock lock(folder.file("used"));
    std::ofstream(folder.file("used/file")) << "kept";
  }
  CHECK(fs::exists(folder.file("used/file")));
}

TEST_CASE("Lock: what is handed down must be the lock of this folder") {
  const TemporaryFolder here, there;
  const tektite::RunLock lock(here.path());
  CHECK_NOTHROW(tektite::RunLock(here.path(), lock.file()));
  CHECK_THROWS_AS(tektite::RunLock(there.path(), lock.file()), tektite::InputError);
  CHECK_THROWS_AS(tektite::RunLock(here.path(), STDERR_FILENO), tektite::InputError);
}

}  // namespace
