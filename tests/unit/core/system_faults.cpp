// What the system refuses is told with the file and the reason.
#include <fcntl.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/apart.hpp"
#include "core/hdf5.hpp"
#include "core/run_lock.hpp"
#include "core/seal.hpp"
#include "core/write_beside.hpp"
#include "support/apart.hpp"
#include "support/temporary_folder.hpp"

namespace tektite {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using test::fault_apart;

struct Written {
  Written() { std::ofstream(path) << "some text"; }
  test::TemporaryFolder folder;
  std::string path = folder.file("file");
};

}  // namespace

TEST_CASE("System: a file for whose seal there is no room is told") {
  const Written file;
  const auto size = fs::file_size(file.path);
  CHECK_THAT(fault_apart([&] {
               test::leave_room(size + 8);
               seal(file.path);
             }),
             StartsWith(file.path + ": cannot be written to its end"));
  CHECK(fault_apart([&] {
          test::leave_room(size + 16);
          fs::resize_file(file.path, size);
          seal(file.path);
        }).empty());
}

TEST_CASE("System: what HDF5 has kept back and cannot bring to the disk is told") {
  const test::TemporaryFolder folder;
  CHECK_THAT(fault_apart([&] {
               hdf5::Writer writer(folder.file("full.h5"));
               writer.group("/group");
               test::leave_room(16);
               writer.close();
             }),
             StartsWith(folder.file("full.h5") + ": cannot be brought to the disk"));
}

TEST_CASE("System: a text for which there is no room, and what was not written at all, are told") {
  const test::TemporaryFolder folder;
  const auto path = folder.file("note.txt");
  CHECK_THAT(fault_apart([&] {
               test::leave_room(4);
               write_text_beside(path, "more than four letters");
             }),
             StartsWith(path + ": cannot be written"));
  CHECK_THROWS_WITH(write_beside(path, [](const std::string&) {}),
                    StartsWith(path) && Contains("cannot be brought to the disk: No such file"));
  fs::create_directories(folder.file("folder/below"));
  CHECK_THROWS_WITH(write_text_beside(folder.file("folder"), "text"),
                    StartsWith(folder.file("folder") + ": cannot be renamed into place: "));
  write_text_beside(path, "in the way");
  CHECK_THROWS_WITH(write_text_beside(path + "/below.txt", "text"),
                    StartsWith(path + ": this folder cannot be made: Not a directory"));
}

TEST_CASE("System: a process that cannot be started or waited for is told with the file that it was to read") {
  const Written file;
  const auto read = [&] { static_cast<void>(can_be_read(file.path, [] {})); };
  CHECK(fault_apart(read).empty());
  CHECK_THAT(fault_apart([&] {
               test::allow_no_process();
               read();
             }),
             StartsWith(file.path) && Contains("no process can be started") && Contains("temporarily unavailable"));
  CHECK_THAT(fault_apart([&] {
               ::signal(SIGCHLD, SIG_IGN);  // the system forgets children of who does not ask for them
               read();
             }),
             StartsWith(file.path) && Contains("a process cannot be waited for: No child processes"));
}

TEST_CASE("System: a folder that cannot be locked is told with the reason") {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.file("run.lock"));
  CHECK_THROWS_WITH(RunLock(folder.path()),
                    folder.file("run.lock") + ": the folder cannot be locked for this run: Is a directory");
  const Written file;
  CHECK_THROWS_WITH(RunLock(file.path + "/below"), StartsWith(file.path + "/below: this folder cannot be made: "));
}

}  // namespace tektite
