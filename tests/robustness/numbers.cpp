// Every number of a scene, replaced by what it cannot be: exit code 2 with place and key, or a scene that works.
#include <fmt/format.h>
#include <toml++/toml.h>

#include <catch2/catch.hpp>
#include <cctype>
#include <cstdlib>
#include <iostream>
#include <random>

#include "robustness/small_run.hpp"

namespace {

namespace fs = std::filesystem;
using namespace tektite::test;
using Catch::Matchers::Contains;

/// A key of a scene and the text of a value for it, for --set.
struct Setting {
  std::string table;  ///< the first word of the key, which a message has to name
  std::string text;
};

bool is_quantity(const std::string& text) {
  const auto first = text.find_first_not_of("+-.");
  return first != std::string::npos && std::isdigit(static_cast<unsigned char>(text[first])) != 0;
}

std::string written(const toml::node& node) {
  std::ostringstream out;
  node.visit([&](const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, toml::table>)
      out << toml::toml_formatter(value, toml::format_flags::none);
    else
      out << value;
  });
  auto text = std::move(out).str();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// What a number is replaced by: negative, zero, not finite, absurd.
std::vector<std::string> wrong_numbers(const toml::node& number) {
  std::vector<std::string> texts;
  for (const std::string value : {"-1", "0", "nan", "inf", "-inf", "1e300", "-1e300", "1e-300", "1e18", "-1e18", "1e9",
                                  "1e-9", "9223372036854775807", "-9223372036854775808"}) {
    const auto text = number.value_exact<std::string>();
    const auto unit = text ? text->find(' ') : std::string::npos;
    texts.push_back(text ? fmt::format("\"{}{}\"", value, unit == std::string::npos ? "" : text->substr(unit)) : value);
  }
  return texts;
}

bool is_number(const toml::node& node) {
  const auto text = node.value_exact<std::string>();
  return node.is_number() || (text && is_quantity(*text));
}

void collect(const toml::node& node, const std::string& key, std::vector<Setting>& settings);

/// Lists are set whole: `text` stands around the element, before and behind it.
void collect_element(const toml::node& node, const std::string& key, const std::string& before,
                     const std::string& behind, std::vector<Setting>& settings) {
  if (is_number(node))
    for (const auto& wrong : wrong_numbers(node))
      settings.push_back({key.substr(0, key.find('.')), key + "=" + before + wrong + behind});
  if (const auto* list = node.as_array())
    for (std::size_t k = 0; k < list->size(); ++k) {
      std::string left = before + "[", right = "]" + behind;
      for (std::size_t j = 0; j < list->size(); ++j) {
        if (j < k) left += written((*list)[j]) + ", ";
        if (j > k) right = ", " + written((*list)[list->size() + k - j]) + right;
      }
      collect_element((*list)[k], key, left, right, settings);
    }
}

void collect(const toml::node& node, const std::string& key, std::vector<Setting>& settings) {
  if (const auto* table = node.as_table())
    for (const auto& [name, value] : *table) {
      if (name.str() == "variant") continue;
      collect(value, key.empty() ? std::string(name.str()) : fmt::format("{}.{}", key, name.str()), settings);
    }
  else
    collect_element(node, key, "", "", settings);
}

std::vector<Setting> settings_of(const std::string& path) {
  std::vector<Setting> settings;
  collect(toml::parse_file(path), "", settings);
  return settings;
}

/// True where the scene works.
bool check_setting(const std::string& folder, const std::string& scene, const Setting& setting) {
  const auto outcome = run_in(folder, {TEKTITE_PROGRAM, "check", scene, "--set", setting.text}, limit_resources);
  INFO(scene << " --set '" << setting.text << "': exit code " << outcome.code << "\n" << outcome.faults);
  CHECK((outcome.code == 0 || outcome.code == 2));
  if (outcome.code == 2) {
    const bool first_steps = outcome.faults.find("the first steps fail") != std::string::npos;
    const bool named = outcome.faults.find("error: --set ") != std::string::npos ||
                       outcome.faults.find("error: " + scene + ":") != std::string::npos;
    CHECK((named || first_steps));
  }
  return outcome.code == 0;
}

/// Some settings out of all those of a scene, or all.
void check_scene(const std::string& folder, const std::string& scene, std::size_t most, unsigned seed) {
  INFO("TEKTITE_SEED=" << seed);
  REQUIRE(run_in(folder, {TEKTITE_PROGRAM, "check", scene}).code == 0);  // else all would be refused, for that
  auto settings = settings_of(folder + "/" + scene);
  REQUIRE(settings.size() > 40);
  std::mt19937 random(seed);
  std::shuffle(settings.begin(), settings.end(), random);
  if (settings.size() > most) settings.resize(most);
  std::size_t works = 0;
  for (const auto& setting : settings) works += check_setting(folder, scene, setting);
  std::cout << scene << ", seed " << seed << ": " << settings.size() << " numbers, " << works << " that work\n";
}

TEST_CASE("Numbers: a wrong one is refused with its place and key, or it works") {
  const TemporaryFolder folder;
  for (const auto* file : {"base.toml", "solid.toml", "cube.off"})
    fs::copy(std::string(WRONG_SCENES) + "/" + file, folder.path());
  check_scene(folder.path(), "base.toml", 20, seed());
  check_scene(folder.path(), "solid.toml", 10, seed());
}

/// A section each (-c NAME).
TEST_CASE("Numbers: a hundred wrong ones of each example", "[.long]") {
  for (const auto& entry : fs::directory_iterator(EXAMPLES)) {
    if (!fs::exists(entry.path() / "scene.toml")) continue;
    const auto name = entry.path().filename().string();
    DYNAMIC_SECTION(name) {
      const TemporaryFolder folder;
      fs::copy(entry.path() / "scene.toml", folder.file(name + ".toml"));
      check_scene(folder.path(), name + ".toml", 100, seed());
    }
  }
}

TEST_CASE("Numbers: 10^12 particles are refused before anything is allocated, with the number asked and allowed") {
  const TemporaryFolder folder;
  fs::copy(std::string(WRONG_SCENES) + "/base.toml", folder.file("scene.toml"));
  fs::copy(std::string(WRONG_SCENES) + "/cube.off", folder.path());
  fs::copy(std::string(WRONG_SCENES) + "/solid.toml", folder.path());
  struct Case {
    std::string scene, setting, says;
  };
  const auto [scene, setting, says] = GENERATE(
      Case{"scene.toml", "spacing=10 nm",
           "this needs about 7.9e+11 particles at a spacing of 1e-08 m, more than 2e+08"},
      Case{"solid.toml", "spacing=1 um", "this needs about 1e+12 particles at a spacing of 1e-06 m, more than 2e+08"},
      Case{"scene.toml", "body.target.arrangement.count=1000000000000", "a count of 1000000000000 is more than 2e+08"},
      Case{"scene.toml",
           "body.target.shape={type=\"union\", parts=[{type=\"disc\", centre=[1, 1], radius=0.001}, "
           "{type=\"disc\", centre=[1e5, 1e5], radius=0.001}]}",
           "the box around the body has"},
      Case{"scene.toml", "body.target.shape.translate=[1e12, 0]", "further from the origin than 1e+09 spacings"});
  constexpr auto little_memory = [] {
    limit_resources();
    const rlimit limit{rlim_t{1} << 30, rlim_t{1} << 30};
    ::setrlimit(RLIMIT_AS, &limit);
  };
  const std::vector<std::vector<std::string>> programs{{TEKTITE_PROGRAM, "check"},
                                                       {stage_program("preprocess"), "-o", "particles.h5"}};
  for (auto words : programs) {
    words.insert(words.end(), {scene, "--set", setting});
    const auto outcome = run_in(folder.path(), words, little_memory);
    INFO(setting << "\n" << outcome.faults);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.faults, Contains(says));
  }
  CHECK_FALSE(fs::exists(folder.file("particles.h5")));
}

}  // namespace
