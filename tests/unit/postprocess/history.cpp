// history.csv: what is read, and what is refused.

#include "postprocess/history.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "support/fault.hpp"
#include "support/temporary_folder.hpp"

namespace tektite::test {
namespace {

History history_of(const std::string& text) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("history.csv")) << text;
  return History::read(folder.file("history.csv"));
}

}  // namespace

TEST_CASE("History: columns are read by name, words are left out") {
  const auto history = history_of("step,time,dt_reason,a.pressure\n0,0,start,1e9\n1,1e-9,sound,-2.5\n");
  CHECK(history.rows() == 2);
  CHECK(history.names() == std::vector<std::string>{"step", "time", "a.pressure"});
  CHECK(history.column("a.pressure") == std::vector<double>{1e9, -2.5});
}

TEST_CASE("History: the line that a killed run did not finish is left out") {
  const auto history = history_of("step,time\n0,0\n1,1e-9\n2,2e");
  CHECK(history.column("time") == std::vector<double>{0.0, 1e-9});
}

TEST_CASE("History: a row that does not fit is told with its line") {
  const auto short_row = fault_of([] { history_of("step,time\n0,0\n1\n"); });
  CHECK(short_row.find("history.csv:3") != std::string::npos);
  CHECK(short_row.find("1 values under 2 names") != std::string::npos);
}

TEST_CASE("History: what is no finite number is told with line, column and value") {
  for (const auto* cell : {"abc", "nan", "1e-9x", ""}) {
    const auto fault = fault_of([&] { history_of(std::string("step,time\n0,") + cell + "\n"); });
    CHECK(fault.find("history.csv:2") != std::string::npos);
    CHECK(fault.find("time") != std::string::npos);
    CHECK(fault.find("not a finite number") != std::string::npos);
  }
}

TEST_CASE("History: an empty file and a missing time are refused") {
  CHECK(fault_of([] { history_of(""); }).find("empty") != std::string::npos);
  CHECK(fault_of([] { history_of("step\n1\n"); }).find("time") != std::string::npos);
  CHECK(fault_of([] { history_of("step,time,time\n1,0,0\n"); }).find("stands twice") != std::string::npos);
  CHECK(fault_of([] { History::read("/no/such/history.csv"); }).find("cannot be opened") != std::string::npos);
}

TEST_CASE("History: a missing column is answered with those that are there") {
  const auto history = history_of("step,time\n0,0\n");
  CHECK_THROWS_WITH(history.column("energy"), Catch::Contains("step, time"));
}

}  // namespace tektite::test
