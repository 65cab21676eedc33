// What tektite check forecasts comes true, and the reduced scene that it writes gives the same measures.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <numeric>
#include <regex>

#include "robustness/small_run.hpp"

namespace {

namespace fs = std::filesystem;
using namespace tektite::test;
using Catch::Matchers::Contains;

/// The number that stands behind the first match of a pattern; NaN where there is none.
double number_behind(const std::string& text, const std::string& pattern) {
  std::smatch match;
  if (!std::regex_search(text, match, std::regex(pattern + "([-+0-9.e]+)"))) return std::nan("");
  return std::stod(match[match.size() - 1]);
}

Outcome run_or_throw(const std::string& folder, const std::vector<std::string>& words) {
  auto outcome = run_in(folder, words);
  if (outcome.code != 0) throw std::runtime_error(outcome.output + outcome.faults);
  return outcome;
}

double size_of(const std::string& folder, bool pictures) {
  double bytes = 0.0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && (pictures || entry.path().extension() != ".png"))
      bytes += static_cast<double>(entry.file_size());
  return bytes;
}

/// Values and uncertainties of measurements.json by name.
std::map<std::string, std::pair<double, double>> measures_of(const std::string& json) {
  std::map<std::string, std::pair<double, double>> measures;
  const std::regex entry(R"re("(\w+)": \{\s*"value": ([-+0-9.e]+),[^}]*"uncertainty": ([-+0-9.e]+))re");
  const auto text = measured(json);
  for (std::sregex_iterator found(text.begin(), text.end(), entry), end; found != end; ++found)
    measures[(*found)[1]] = {std::stod((*found)[2]), std::stod((*found)[3])};
  return measures;
}

struct Case {
  std::string example, variant;
  std::vector<std::string> settings;
};

/// Several schemes and spaces, some seconds each.
const std::vector<Case> cases{{"hvi_2d", "sav1", {"spacing='0.2 mm'"}},
                              {"collapsing_ring", "split1", {"spacing='2.222222222222222 mm'"}},
                              {"taylor_bar", "total_lagrangian", {"spacing=6.329166666666667e-4"}},
                              {"noh", "planar", {"spacing=0.0025"}},
                              {"debris_3d", "total_lagrangian", {"spacing='1.5 mm'", "time.end='30 us'"}}};

/// What is forecast of the five cases against what comes; of the time only where this machine's clock is `trusted`.
void compare_forecasts(bool trusted) {
  constexpr double time_and_disk = 0.25, memory = 0.10;
  for (const auto& [example, variant, settings] : cases) {
    DYNAMIC_SECTION(example) {
      const TemporaryFolder folder;
      fs::create_directory(folder.file("run"));
      std::vector<std::string> filling{stage_program("preprocess"),
                                       std::string(EXAMPLES) + "/" + example + "/scene.toml",
                                       "-o",
                                       "run/particles.h5",
                                       "--variant",
                                       variant};
      for (const auto& setting : settings) filling.insert(filling.end(), {"--set", setting});
      run_or_throw(folder.path(), filling);
      const auto told = run_or_throw(folder.path(), {stage_program("solve"), "--check", "run/particles.h5", "--advice",
                                                     "advice", "--threads", "1"})
                            .output;
      run_or_throw(folder.path(), {stage_program("solve"), "run", "--threads", "1"});
      run_or_throw(folder.path(), {stage_program("postprocess"), "run", "--no-pictures"});
      const auto summary = content_of(folder.file("run/solve.json"));
      const double seconds = number_behind(told, "\nabout ");
      const double steps = number_behind(told, ": about ");
      INFO(told << summary);
      const auto compare = [&, name = example](const std::string& what, double forecast, double came, double within) {
        std::cout << name << ": " << what << " " << forecast << " forecast, " << came << " came, "
                  << 100.0 * (forecast / came - 1.0) << " %" << std::endl;
        CHECK(forecast == Approx(came).epsilon(within));
      };
      compare("steps", steps, number_behind(summary, "\"steps\": "), time_and_disk);
      if (trusted) compare("seconds", seconds, number_behind(summary, "\"cpu_seconds\": "), time_and_disk);
      compare("MB of memory", number_behind(told, "memory "), 1e-6 * number_behind(summary, "\"peak_memory_bytes\": "),
              memory);
      compare("MB of disk", number_behind(told, "disk "), 1e-6 * size_of(folder.file("run"), false), time_and_disk);
    }
  }
}

TEST_CASE("Check: steps, memory and disk are as forecast in five cases") { compare_forecasts(false); }
TEST_CASE("Check: so is the time, on a machine that has nothing else to do", "[.long]") { compare_forecasts(true); }

const std::string aluminium = R"([material.aluminium]
density = "2785 kg/m3"
eos = { model = "mie-grueneisen", bulk_sound_speed = "5328 m/s", hugoniot_slope = 1.338, grueneisen = 2.0 }
strength = { model = "perfectly-plastic", shear_modulus = "27.6 GPa", yield_stress = "0.3 GPa" }
)";

/// Discs and balls that strike long plates at their middle.
const std::string plane_impact = R"(name = "impact"
space = "plane-strain"
spacing = "0.25 mm"
)" + aluminium + R"([body.disc]
material = "aluminium"
shape = { type = "disc", centre = ["-3.5 mm", 0], radius = "2.5 mm" }
arrangement = { type = "lattice", convention = "half-off-origin" }
velocity = ["2 km/s", 0]
[body.plate]
material = "aluminium"
shape = { type = "rectangle", lower = [0, "-40 mm"], upper = ["2 mm", "40 mm"] }
[time]
end = "3 us"
[probe.centre]
body = "disc"
position = ["-3.5 mm", "-0.125 mm"]
[measure.peak_pressure]
probe = "centre"
[measure.crater_diameter]
body = "plate"
[measure.projectile_extension]
body = "disc"
[measure.projectile_travel]
body = "disc"
)";

const std::string solid_impact = R"(name = "impact"
space = "solid"
spacing = "1 mm"
contact = { model = "kernel-penalty", exponent = 4 }
scheme.type = "total-lagrangian"
)" + aluminium + R"([body.ball]
material = "aluminium"
shape = { type = "sphere", centre = ["-4 mm", 0, 0], radius = "3 mm" }
arrangement = { type = "lattice", convention = "half-off-origin" }
velocity = ["800 m/s", 0, 0]
[body.plate]
material = "aluminium"
shape = { type = "box", lower = [0, "-40 mm", "-40 mm"], upper = ["3 mm", "40 mm", "40 mm"] }
[time]
end = "4 us"
[measure.debris_velocity]
body = "ball"
[measure.min_pressure]
body = "plate"
[measure.max_plastic_strain]
body = "plate"
[measure.projectile_travel]
body = "ball"
)";

TEST_CASE("Check: the reduced scene that --apply writes gives the same measures, with the promised particles") {
  struct Impact {
    std::string scene;
    double factor;  ///< saved at least, of both mirrors and reach
  };
  const auto [scene, factor] = GENERATE(Impact{plane_impact, 3.0}, Impact{solid_impact, 4.0});
  const TemporaryFolder folder;
  std::ofstream(folder.file("scene.toml")) << scene;
  const auto told = run_or_throw(folder.path(), {TEKTITE_PROGRAM, "check", "scene.toml", "--apply", "reduced.toml"});
  INFO(told.output << content_of(folder.file("reduced.toml")));
  CHECK_THAT(told.output, Contains("mirror images") && Contains("no wave comes further"));
  for (const std::string run : {"scene", "reduced"})
    run_or_throw(folder.path(), {TEKTITE_PROGRAM, "run", run + ".toml", "-o", run, "--threads", "1", "--no-pictures"});
  const auto whole = content_of(folder.file("scene/measurements.json"));
  const auto part = content_of(folder.file("reduced/measurements.json"));
  CHECK(number_behind(whole, "\"particles\": ") / number_behind(part, "\"particles\": ") > factor);
  const auto measures = measures_of(whole);
  REQUIRE(measures.size() == 4);
  for (const auto& [name, measure] : measures) {
    const auto other = measures_of(part).at(name);
    std::cout << name << ": " << measure.first << " in full, " << other.first << " reduced, uncertainty "
              << measure.second << std::endl;
    INFO(name);
    CHECK(other.first == Approx(measure.first).margin(measure.second));
  }
  const auto again = run_in(folder.path(), {TEKTITE_PROGRAM, "check", "scene.toml", "--apply", "reduced.toml"});
  CHECK(again.code == 2);
  CHECK_THAT(again.faults, Contains("reduced.toml") && Contains("is there already"));
  fs::create_directory(folder.file("below"));
  const auto elsewhere = run_in(folder.path(), {TEKTITE_PROGRAM, "check", "scene.toml", "--apply", "below/other.toml"});
  CHECK(elsewhere.code == 2);
  CHECK_THAT(elsewhere.faults, Contains("below/other.toml: paths in a scene are relative to its folder"));
  // What is reduced has no more to be saved.
  const auto reduced = run_or_throw(folder.path(), {TEKTITE_PROGRAM, "check", "reduced.toml", "--apply", "none.toml"});
  CHECK_THAT(reduced.output, Contains("nothing to save is known"));
  CHECK_FALSE(fs::exists(folder.file("none.toml")));
}

}  // namespace
