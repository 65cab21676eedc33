// Every wrong scene of wrong_scenes/cases.toml is refused by the real programs: exit code 2, one message with file,
// line, key, reason and what is allowed, and nothing left behind.
#include <toml++/toml.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace {

namespace fs = std::filesystem;
using tektite::test::content_of;
using tektite::test::run_in;
using tektite::test::TemporaryFolder;

const std::string tables = WRONG_SCENES;
const std::string tektite_program = TEKTITE_PROGRAM;

std::vector<std::string> texts(const toml::table& table, const char* key) {
  std::vector<std::string> values;
  if (const auto* array = table[key].as_array())
    for (const auto& value : *array) values.push_back(value.value<std::string>().value());
  return values;
}

/// One row of the table.
struct WrongScene {
  std::string name;
  std::string base;                    ///< the scene from which it is made
  std::vector<std::string> replace;    ///< a piece of the base scene and what stands there instead
  std::string append;                  ///< what stands below the base scene
  std::string whole;                   ///< a scene of its own in place of the base
  std::string line_of;                 ///< where the message points: the first line with this text
  std::vector<std::string> arguments;  ///< further words of the command line
  std::vector<std::string> says;       ///< pieces of the message
  std::vector<std::pair<std::string, std::string>> files;
};

std::vector<WrongScene> read_cases() {
  const auto document = toml::parse_file(tables + "/cases.toml");
  std::vector<WrongScene> cases;
  for (const auto& element : *document["case"].as_array()) {
    const auto& row = *element.as_table();
    WrongScene wrong{row["name"].value<std::string>().value(),
                     row["base"].value_or(std::string("base.toml")),
                     texts(row, "replace"),
                     row["append"].value_or(std::string()),
                     row["whole"].value_or(std::string()),
                     row["line_of"].value_or(std::string()),
                     texts(row, "arguments"),
                     texts(row, "says"),
                     {}};
    if (const auto* files = row["files"].as_table())
      for (const auto& [name, text] : *files) wrong.files.emplace_back(name.str(), text.value<std::string>().value());
    cases.push_back(wrong);
  }
  return cases;
}

std::string scene_of(const WrongScene& wrong) {
  if (!wrong.whole.empty()) return wrong.whole;
  auto scene = content_of(tables + "/" + wrong.base);
  for (std::size_t k = 0; k + 1 < wrong.replace.size(); k += 2) {
    const auto at = scene.find(wrong.replace[k]);
    if (at == std::string::npos) throw std::runtime_error("the base scene has not " + wrong.replace[k]);
    scene.replace(at, wrong.replace[k].size(), wrong.replace[k + 1]);
  }
  return scene + wrong.append;
}

/// "scene.toml:LINE:" of the place to which the message has to point; empty where the row does not say.
std::string place_of(const WrongScene& wrong, const std::string& scene) {
  if (wrong.line_of.empty()) return {};
  const auto at = scene.find(wrong.line_of);
  if (at == std::string::npos) throw std::runtime_error("the scene has no line with " + wrong.line_of);
  const auto line = 1 + std::count(scene.begin(), scene.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  return "scene.toml:" + std::to_string(line) + ":";
}

void write(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

/// The base scene's meshes and this row's own files, in a folder where the scene is run.
void fill(const TemporaryFolder& folder, const WrongScene& wrong, const std::string& scene) {
  for (const auto& entry : fs::directory_iterator(tables))
    if (entry.path().extension() == ".off") fs::copy(entry.path(), folder.path());
  for (const auto& [name, text] : wrong.files) write(folder.file(name), text);
  write(folder.file("scene.toml"), scene);
}

void check_refusal(const WrongScene& wrong, const tektite::test::Outcome& outcome, const std::string& place) {
  using Catch::Matchers::Contains;
  CHECK(outcome.code == 2);
  const bool one_line = std::count(outcome.faults.begin(), outcome.faults.end(), '\n') == 1;
  INFO("standard error was: " << outcome.faults);
  CHECK(one_line);
  CHECK_THAT(outcome.faults, Catch::StartsWith("tektite") && Contains(": error: ") && Contains(place));
  for (const auto& piece : wrong.says) CHECK_THAT(outcome.faults, Contains(piece));
}

TEST_CASE("Wrong scenes: the scenes from which they are made are right") {
  const std::string base = GENERATE(as<std::string>(), "base.toml", "solid.toml");
  const TemporaryFolder folder;
  fill(folder, {}, content_of(tables + "/" + base));
  const auto outcome = run_in(folder.path(), {tektite_program, "check", "scene.toml"});
  INFO(outcome.faults);
  CHECK(outcome.code == 0);
  CHECK(outcome.faults.empty());
}

TEST_CASE("Wrong scenes: each is refused with one message and leaves nothing behind") {
  const auto cases = read_cases();
  REQUIRE(cases.size() >= 60);
  for (const auto& wrong : cases) {
    DYNAMIC_SECTION(wrong.name) {
      const auto scene = scene_of(wrong);
      const auto place = place_of(wrong, scene);
      const TemporaryFolder folder;
      fill(folder, wrong, scene);
      std::vector<std::string> words{tektite_program, "run", "scene.toml", "-o", "out"};
      words.insert(words.end(), wrong.arguments.begin(), wrong.arguments.end());
      check_refusal(wrong, run_in(folder.path(), words), place);
      CHECK_FALSE(fs::exists(folder.file("out")));

      words = {tektite_program, "check", "scene.toml"};
      words.insert(words.end(), wrong.arguments.begin(), wrong.arguments.end());
      check_refusal(wrong, run_in(folder.path(), words), place);
    }
  }
}

}  // namespace
