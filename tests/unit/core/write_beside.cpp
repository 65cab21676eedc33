// Nothing computed is lost: a file is whole or as it was.
#include "core/write_beside.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "core/error.hpp"
#include "core/snapshot.hpp"
#include "support/particles.hpp"
#include "support/temporary_folder.hpp"

namespace tektite {
namespace {

namespace fs = std::filesystem;

std::string content(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t files_in(const std::string& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST_CASE("Writing beside: the file is there whole, in folders made for it, and alone") {
  const test::TemporaryFolder folder;
  write_text_beside(folder.file("a/b/note.txt"), "first");
  write_text_beside(folder.file("a/b/note.txt"), "second");
  CHECK(content(folder.file("a/b/note.txt")) == "second");
  CHECK(files_in(folder.file("a/b")) == 1);
}

TEST_CASE("Writing beside: a write that fails leaves the old file and nothing else") {
  const test::TemporaryFolder folder;
  const auto path = folder.file("note.txt");
  write_text_beside(path, "old");
  const auto failing = [](const std::string& beside) {
    std::ofstream(beside) << "half of the n";
    throw RunError("the disk is full");
  };
  CHECK_THROWS_AS(write_beside(path, failing), RunError);
  CHECK(content(path) == "old");
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("Writing beside: a program killed while it writes leaves the old file") {
  const test::TemporaryFolder folder;
  const auto path = folder.file("note.txt");
  write_text_beside(path, "old");
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    write_beside(path, [](const std::string& beside) {
      std::ofstream(beside) << "half of the n" << std::flush;
      ::raise(SIGKILL);
    });
    ::_exit(0);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(WIFSIGNALED(status));
  CHECK(content(path) == "old");
  write_text_beside(path, "new");  // what the killed program left beside is no obstacle
  CHECK(content(path) == "new");
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("Writing beside: a snapshot for which there is no room on the disk is a RunError and leaves the old one") {
  const test::TemporaryFolder folder;
  const auto path = folder.file("particles.h5");
  const Snapshot old{test::filled_particles(Space::line), {{"time", 0.0}}, "name = \"old\""};
  write_snapshot(old, path);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};  // a disk on which a file of one page is all that fits
    ::setrlimit(RLIMIT_FSIZE, &limit);
    int code = 0;
    try {
      write_snapshot({test::filled_particles(Space::solid), {{"time", 1.0}}, "name = \"new\""}, path);
    } catch (const RunError&) {
      code = 17;
    }
    ::_exit(code);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 17);
  CHECK(read_snapshot(path).scene == old.scene);
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("Writing beside: a folder that cannot be made is a RunError") {
  const test::TemporaryFolder folder;
  write_text_beside(folder.file("file"), "in the way");
  CHECK_THROWS_AS(write_text_beside(folder.file("file/below.txt"), "text"), RunError);
  fs::create_directory(folder.file("folder"));
  write_text_beside(folder.file("folder/inside.txt"), "text");
  CHECK_THROWS_AS(write_text_beside(folder.file("folder"), "text"), RunError);
  CHECK(files_in(folder.path()) == 2);
}

}  // namespace
}  // namespace tektite
