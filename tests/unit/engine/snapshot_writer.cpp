// A snapshot that is written while the run goes on is that of its moment, and what fails is told.
#include "output/snapshot_writer.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/error.hpp"
#include "parallel/threads.hpp"
#include "support/apart.hpp"
#include "support/particles.hpp"
#include "support/temporary_folder.hpp"

namespace tektite {
namespace {

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Snapshot state() { return {test::filled_particles(Space::solid), {{"time", 1.0}}, "name = \"state\""}; }

TEST_CASE("Snapshot writer: the file holds the state of its moment, without scratch, whatever comes afterwards") {
  const test::TemporaryFolder folder;
  const History history(folder.file("history.csv"), {"energy"});
  write_snapshot(state(), folder.file("at_once.h5"));
  auto run = state();
  run.particles.allocate(Field::half_density);
  SnapshotWriter writer;
  for (const std::string name : {"first.h5", "second.h5"}) {  // the second in the room of the first one's copy
    writer.start(run, folder.file(name), &history);
    for (auto& number : run.particles.reals(Field::velocity)) number = -1.0;
    for (auto& number : run.particles.integers(Field::id)) number = -1;
    run.state["time"] = 2.0;
    CHECK(writer.busy());
    writer.finish();
    CHECK_FALSE(writer.busy());
    run = state();
    CHECK(content(folder.file(name)) == content(folder.file("at_once.h5")));
  }
}

TEST_CASE("Snapshot writer: what cannot be written is told once, by finish(), and the next one is written") {
  const test::TemporaryFolder folder;
  const History history(folder.file("history.csv"), {"energy"});
  std::ofstream(folder.file("file")) << "in the way";
  SnapshotWriter writer;
  CHECK_NOTHROW(writer.start(state(), folder.file("file/000000.h5"), &history));
  CHECK_THROWS_AS(writer.finish(), RunError);
  CHECK_NOTHROW(writer.finish());
  writer.start(state(), folder.file("000001.h5"), &history);
  CHECK_NOTHROW(writer.finish());
  CHECK(read_snapshot(folder.file("000001.h5")).state == state().state);
}

TEST_CASE("Snapshot writer: one that goes leaves its file whole, where the system has no thread to give too") {
  const test::TemporaryFolder folder;
  std::filesystem::permissions(folder.path(), std::filesystem::perms::all);  // for whom no thread is given
  const History history(folder.file("history.csv"), {"energy"});
  SnapshotWriter().start(state(), folder.file("threaded.h5"), &history);
  CHECK_NOTHROW(read_snapshot(folder.file("threaded.h5")));
  CHECK(test::fault_apart([&] {
          use_threads(1);
          test::allow_no_process();
          SnapshotWriter writer;
          writer.start(state(), folder.file("waited_for.h5"), &history);
          if (writer.at_work()) throw std::logic_error("a thread was given");
          writer.finish();
          writer.start(state(), folder.file("not_waited_for.h5"), &history);
        }).empty());
  CHECK_NOTHROW(read_snapshot(folder.file("waited_for.h5")));
  CHECK_NOTHROW(read_snapshot(folder.file("not_waited_for.h5")));
}

}  // namespace
}  // namespace tektite
