// docs/scenes.md names every key and every name that the programs say they allow.
#include <catch2/catch.hpp>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.hpp"

namespace {

namespace fs = std::filesystem;
using tektite::test::content_of;
using tektite::test::run_in;
using tektite::test::TemporaryFolder;

/// What stands in "(allowed: a, b, c)" at the end of a message.
std::vector<std::string> allowed_in(const std::string& message) {
  const std::string mark = "(allowed: ";
  const auto begin = message.rfind(mark);
  const auto end = message.rfind(')');
  if (begin == std::string::npos || end == std::string::npos) return {};
  std::istringstream list(message.substr(begin + mark.size(), end - begin - mark.size()));
  std::vector<std::string> words;
  for (std::string word; std::getline(list >> std::ws, word, ',');) words.push_back(word);
  return words;
}

/// As `word`, within `table.word` or `{ word, ... }`, or as the table [word] or tables [word.NAME].
bool documents(const std::string& page, const std::string& word) {
  for (const auto& form : {"`" + word + "`", "." + word + "`", "{ " + word + ",", ", " + word + " }", ", " + word + ",",
                           "`[" + word + ".", "`[" + word + "]"})
    if (page.find(form) != std::string::npos) return true;
  return false;
}

TEST_CASE("docs/scenes.md names every key and name that the programs offer") {
  const auto page = content_of(SCENES_PAGE);
  REQUIRE_FALSE(page.empty());
  const std::string base = WRONG_SCENES;
  const std::string scene = GENERATE(as<std::string>(), "base.toml", "solid.toml");
  const std::string body = scene == "base.toml" ? "projectile" : "block";
  const std::string shape = scene == "base.toml" ? "{type=\"disc\", radius=1}" : "{type=\"sphere\", radius=1}";
  std::vector<std::string> settings{"unknown=1",
                                    "space=unknown",
                                    "body." + body + ".unknown=1",
                                    "body." + body + ".shape.unknown=1",
                                    "body." + body + ".shape={type=\"unknown\"}",
                                    "body." + body + ".arrangement={type=\"unknown\"}",
                                    "body." + body + ".arrangement={type=\"lattice\", unknown=1}",
                                    "body." + body + ".arrangement={convention=\"unknown\"}",
                                    "body." + body + ".arrangement={mass=\"unknown\"}",
                                    "body." + body + ".velocity={type=\"unknown\"}",
                                    "body." + body + ".region.one={shape=" + shape + ", unknown=1}",
                                    "body." + body + ".region.one={shape=" + shape + ", kernel=\"unknown\"}",
                                    "material.aluminium.unknown=1",
                                    "material.aluminium.eos={model=\"unknown\"}",
                                    "material.aluminium.eos.unknown=1",
                                    "material.aluminium.strength={model=\"unknown\"}",
                                    "material.aluminium.strength={model=\"none\", unknown=1}",
                                    "smoothing.unknown=1",
                                    "smoothing.kernel=unknown",
                                    "scheme.unknown=1",
                                    "scheme.type=unknown",
                                    "viscosity.unknown=1",
                                    "viscosity.model=unknown",
                                    "symmetry.middle={axis=\"unknown\"}",
                                    "symmetry.middle={axis=\"x\", unknown=1}",
                                    "symmetry.middle={axis=\"x\", keep=\"unknown\"}",
                                    "time.unknown=1",
                                    "time.from=unknown",
                                    "output.unknown=1",
                                    "stop_when.one={type=\"unknown\"}",
                                    "measure.one={type=\"unknown\"}",
                                    "measure.max_plastic_strain={body=\"" + body + "\", unknown=1}",
                                    "picture.one={type=\"unknown\"}",
                                    "picture.one={field=\"pressure\", unknown=1}",
                                    "picture.one={type=\"history\", unknown=1}"};
  for (const auto& setting : settings) {
    INFO(scene << " --set " << setting);
    const TemporaryFolder folder;
    for (const auto& entry : fs::directory_iterator(base))
      if (entry.is_regular_file()) fs::copy(entry.path(), folder.path());
    const auto outcome = run_in(folder.path(), {TEKTITE_PROGRAM, "check", scene, "--set", setting});
    CHECK(outcome.code == 2);
    const auto words = allowed_in(outcome.faults);
    INFO(outcome.faults);
    CHECK_FALSE(words.empty());
    for (const auto& word : words) {
      INFO(word);
      CHECK(documents(page, word));
    }
  }
}

}  // namespace
