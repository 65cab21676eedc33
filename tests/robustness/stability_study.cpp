// tektite stability as a user meets it: a wrong study is refused with its place, and a part without an answer is told.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "support/program.hpp"

namespace {

using Catch::Matchers::Contains;
using tektite::test::Outcome;
using tektite::test::run_in;
using tektite::test::TemporaryFolder;

const std::string study = R"(name = "tiny"
scene = "scene.toml"
stress = { least = "-1 GPa", largest = "1 GPa", count = 2 }
ratio = { least = 1.0, largest = 1.5, count = 2 }
waves = 1
shown = { stress = "1 GPa", ratio = 1.4 }
material = "aluminium"
[line.eulerian]
)";

void lay_out(const TemporaryFolder& folder, const std::string& text) {
  std::filesystem::copy(std::string(WRONG_SCENES) + "/base.toml", folder.file("scene.toml"));
  std::ofstream(folder.file("study.toml")) << text;
}

/// The study with `now` in place of `old`.
Outcome changed(const std::string& old, const std::string& now) {
  const TemporaryFolder folder;
  auto wrong = study;
  wrong.replace(wrong.find(old), old.size(), now);
  lay_out(folder, wrong);
  return run_in(folder.path(), {TEKTITE_PROGRAM, "stability", "study.toml"});
}

std::string refused(const std::string& old, const std::string& now) {
  const auto outcome = changed(old, now);
  CHECK(outcome.code == 2);
  return outcome.faults;
}

TEST_CASE("Stability study: a wrong one is refused with its place") {
  CHECK_THAT(refused("tiny", "../tiny"), Contains("study.toml:1: name") && Contains("so it must be plain"));
  CHECK_THAT(refused("\"1 GPa\", count", "\"-1 GPa\", count"),
             Contains("study.toml:3: stress.largest") && Contains("is not above least (allowed: a larger value)"));
  CHECK_THAT(refused("line.eulerian", "line.\"a b\""), Contains("line.a b: names columns, so it must be plain"));
  CHECK_THAT(refused("\"aluminium\"", "\"gold\""),
             Contains("scene.toml: material = gold: the study has to name a material of this scene") &&
                 Contains("(allowed: aluminium, steel)"));
  CHECK_THAT(refused("material = \"aluminium\"", ""), Contains("the study has to name a material of this scene"));
  CHECK_THAT(refused("[line.eulerian]", "[line.eulerian]\nset = [\"space=axisymmetric\"]"),
             Contains("space = axisymmetric: stability is analysed on a straight line or in a plane"));
  CHECK_THAT(refused("[line.eulerian]", ""), Contains("there is nothing to analyse (allowed: [line.NAME])"));
}

TEST_CASE("Stability study: what is no folder, and tables that are not those of the study, are refused") {
  const TemporaryFolder folder;
  lay_out(folder, study);
  CHECK_THAT(run_in(folder.path(), {TEKTITE_PROGRAM, "stability", "study.toml", "-o", "study.toml"}).faults,
             Contains("this is no folder"));
  const auto drawn_of = [&](const std::string& table) {
    std::filesystem::create_directory(folder.file("out"));
    if (!table.empty()) std::ofstream(folder.file("out/growth.csv")) << table;
    const auto outcome =
        run_in(folder.path(), {TEKTITE_PROGRAM, "postprocess", "--stability", "study.toml", "-o", "out"});
    CHECK(outcome.code == 2);
    return outcome.faults;
  };
  CHECK_THAT(drawn_of(""), Contains("growth.csv") && Contains("the table cannot be read"));
  CHECK_THAT(drawn_of("line,stress,ratio,growth\neulerian,much,1,1\n"),
             Contains("growth.csv:2: stress = much: not a number"));
  CHECK_THAT(drawn_of("line,stress,ratio,growth\nother,1,1,1\n"), Contains("eulerian") && Contains("has no rows"));
}

TEST_CASE("Stability study: a stress that the equation of state does not reach has no answer, and others have") {
  const auto outcome = changed("-1 GPa", "-1e9 GPa");
  CHECK(outcome.code == 0);
  CHECK_THAT(outcome.output,
             Contains("no answer for") && Contains("the equation of state of aluminium does not reach it"));
}

}  // namespace
