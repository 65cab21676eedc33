// Several ranks make particles as one process does, byte for byte, and tell what is wrong once.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "robustness/on_ranks.hpp"
#include "robustness/small_run.hpp"

namespace {

namespace fs = std::filesystem;
using namespace tektite::test;

std::string head(const std::string& space) {
  return "name = 'particles'\nspace = '" + space + R"('
spacing = "0.5 mm"
scheme.type = "total-lagrangian"
time.end = "1 us"
output.snapshots = "1 us"
)" + small_material;
}

/// A ball cut by a plane, with a region, above a plate.
const std::string solid = head("solid") + R"(
[symmetry.middle]
axis = "x"

[body.ball]
material = "aluminium"
shape = { type = "sphere", centre = [0, 0, "-5.3 mm"], radius = "5 mm" }
arrangement = { type = "shells", mass = "exact" }
velocity = [0, 0, "-100 m/s"]

[body.ball.region.core]
shape = { type = "sphere", centre = [0, 0, "-5.3 mm"], radius = "2 mm" }
density = "3000 kg/m3"
specific_internal_energy = 1e5

[body.plate]
material = "aluminium"
shape = { type = "box", lower = ["-8 mm", "-8 mm", 0], upper = ["8 mm", "8 mm", "3 mm"] }
arrangement = { type = "close-packed", mass = "exact" }
velocity = { type = "rotation", rate = 1e4, centre = [0, 0, 0], axis = [0, 0.3, 1] }
)";

/// A disc and the ring about it, above a plate of edges-included rows.
const std::string plane = head("plane-strain") + R"(
[body.disc]
material = "aluminium"
shape = { type = "disc", centre = [0, 0], radius = "5 mm" }
arrangement = { type = "lattice-with-rings", mass = "exact" }

[body.ring]
material = "aluminium"
shape = { type = "ring", centre = [0, 0], inner_radius = "5.5 mm", outer_radius = "8 mm" }
arrangement = { type = "rings" }

[body.plate]
material = "aluminium"
shape = { type = "rectangle", lower = ["-9 mm", "9 mm"], upper = ["9 mm", "12 mm"] }
arrangement = { convention = "edges-included" }
)";

/// A scene in a folder of its own, and what is made of it.
class Scene {
 public:
  explicit Scene(const std::string& scene) { std::ofstream(folder_.file("scene.toml")) << scene; }

  static std::vector<std::string> words(std::vector<std::string> more = {}) {
    std::vector<std::string> words{stage_program("preprocess"), "scene.toml", "-o",
                                   "out/particles.h5",          "--threads",  "1"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  Outcome run(const std::vector<std::string>& words) const { return run_in(folder_.path(), words); }
  std::string particles() const { return content_of(folder_.file("out/particles.h5")); }
  /// Whether nothing is left, not even half of a file.
  bool nothing_left() const { return !fs::exists(folder_.file("out")) || fs::is_empty(folder_.file("out")); }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

void check_ranks(const std::string& text, const std::vector<std::string>& settings, const std::vector<int>& ranks) {
  const Scene scene(text);
  const auto words = Scene::words(settings);
  const auto one = scene.run(words);
  INFO(one.faults);
  REQUIRE(one.code == 0);
  const auto particles = scene.particles();
  for (const int count : ranks) {
    INFO(count << " ranks");
    fs::remove_all(scene.folder().file("out"));
    const auto many = scene.run(on_ranks(count, words));
    INFO(many.faults);
    REQUIRE(many.code == 0);
    CHECK(many.output == one.output);
    CHECK((scene.particles() == particles));
  }
}

TEST_CASE("Ranks: the particles that several make, and the report, are those of one process byte for byte") {
  check_ranks(solid, {}, {2, 3, 7});
  check_ranks(plane, {}, {4});
  check_ranks(plane, {"--set", "body.disc.arrangement={type='lattice', count=500}"}, {3});
}

TEST_CASE("Ranks: more of them than there are particles make the same file") {
  check_ranks(head("line") + R"(
[body.rod]
material = "aluminium"
shape = { type = "segment", lower = 0, upper = "2 mm" }
)",
              {}, {7});
}

TEST_CASE("Ranks: what is wrong with a scene is told once, as one process tells it, whichever of them finds it") {
  const auto setting = GENERATE(as<std::string>(), "body.ball.shape.centre=[0, 0, '-4.7 mm']",  // overlaps
                                "body.ball.region.core.shape.centre=[0, 0, '9 mm']", "body.ball.material='wood'");
  const Scene scene(solid);
  const auto words = Scene::words({"--set", setting});
  const auto one = scene.run(words);
  REQUIRE(one.code == 2);
  const auto many = scene.run(on_ranks(3, words));
  INFO(many.faults);
  CHECK(many.code == 2);
  CHECK(count_of("tektite-preprocess: error:", many.faults) == 1);
  CHECK(count_of(one.faults, many.faults) == 1);
  CHECK(scene.nothing_left());
}

/// What a shell does first on the rank 1 alone.
std::vector<std::string> after_on_rank_1(const std::string& first) {
  return {"/bin/sh", "-c",
          "test $OMPI_COMM_WORLD_RANK != 1 || " + first + "; exec " + stage_program("preprocess") +
              " scene.toml -o out/particles.h5 --set 'spacing=\"0.03 mm\"'"};
}

TEST_CASE("Ranks: where one of them cannot write, it is told once and no half of a file is left") {
  const Scene scene(plane);
  // 9 MB in blocks of 512 bytes: enough for what the launcher writes, and half of what is to be written.
  const auto outcome = scene.run(on_ranks(3, after_on_rank_1("ulimit -f 18432")));
  INFO(outcome.faults);
  CHECK(outcome.code == 1);
  CHECK(count_of("tektite-preprocess: error: out/particles.h5.part: cannot be written: File too large",
                 outcome.faults) == 1);
  CHECK(count_of("tektite-preprocess: error:", outcome.faults) == 1);
  CHECK(scene.nothing_left());
}

TEST_CASE("Ranks: one that is killed ends the others") {
  const Scene scene(plane);
  CHECK(scene.run(on_ranks(3, after_on_rank_1("kill -9 $$"))).code != 0);
  CHECK(scene.nothing_left());
}

}  // namespace
