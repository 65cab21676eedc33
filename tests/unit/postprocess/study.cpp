// A study that has been run, on folders made by hand: what is read, judged and said.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "postprocess/study/verdict.hpp"
#include "support/fault.hpp"
#include "support/temporary_folder.hpp"

using namespace tektite;
using Catch::Matchers::Contains;

namespace {

namespace fs = std::filesystem;

/// A study of two lines at three resolutions, judged by a radius of 50 mm.
struct Made {
  test::TemporaryFolder folder;

  Made() {
    write("scene.toml",
          "name = 'ring'\nspace = 'plane-strain'\nspacing = '1 mm'\n[body.ring]\nmaterial = 'metal'\n"
          "[measure.inner_radius]\nbody = 'ring'\n[measure.symmetry_error]\nbody = 'ring'\n[variant.other]\n");
    write("reference.toml",
          "[[reference]]\nmeasure = 'inner_radius'\npublished = '50 mm'\nsource = 'the exact one'\n"
          "[[reference]]\nmeasure = 'inner_radius'\nvariant = 'other'\npublished = '40 mm'\nsource = 'a guess'\n");
  }
  void write(const std::string& file, const std::string& text) const {
    fs::create_directories(fs::path(folder.file(file)).parent_path());
    std::ofstream(folder.file(file)) << text;
  }
  void run(const std::string& member, double cost, double radius) const {
    write("runs/" + member + "/measurements.json",
          fmt::format(R"({{"cpu_seconds": {}, "particles": 10, "steps": 5, "measurements":
                      {{"inner_radius": {{"value": {}, "uncertainty": 0.0005}}, "symmetry_error": {{"value": 0.5,
                      "uncertainty": 0}}}}}})",
                      cost, radius));
  }
  JudgedStudy study(const std::string& error, const std::string& more = "") const {
    write("study.toml", "name = 'rings'\nscene = 'scene.toml'\n" + more +
                            "resolutions = [{ factor = 1 }, { factor = 4 }, { factor = 2 }]\n" + error +
                            "[line.a]\n[line.b]\nset = ['smoothing.ratio = 2']\n");
    return read_judged_study(folder.file("study.toml"));
  }
};

const std::string by_radius = "[[error]]\nmeasure = 'inner_radius'\n";

}  // namespace

TEST_CASE("Study: members are named after line and factor, coarsest first, with their spacing laid over the scene") {
  const Made made;
  const auto judged = made.study(by_radius);
  REQUIRE(judged.study.lines.size() == 2);
  const auto& members = judged.study.lines[1].members;
  REQUIRE(members.size() == 3);
  CHECK(members[0].name == "b-4");
  CHECK(members[0].spacing == Approx(4e-3));
  CHECK(members[2].settings == std::vector<std::string>{"smoothing.ratio = 2", "spacing=0.001"});
  CHECK(members[2].scene == made.folder.file("scene.toml"));
}

TEST_CASE("Study: bodies with a spacing of their own are refined alike, and a count is refused") {
  const Made made;
  made.write(
      "scene.toml",
      "name = 'ring'\nspace = 'plane-strain'\nspacing = 1\n[body.ring]\nspacing = 3\n[measure.inner_radius]\nbody = "
      "'ring'\n");
  CHECK(made.study(by_radius).study.lines[0].members[1].settings ==
        std::vector<std::string>{"spacing=2", "body.ring.spacing=6"});
  made.write(
      "scene.toml",
      "name = 'ring'\nspace = 'plane-strain'\nspacing = 1\n[body.ring]\narrangement = { type = 'lattice', count = "
      "9 }\n[measure.inner_radius]\nbody = 'ring'\n");
  CHECK_THAT(test::fault_of([&] { made.study(by_radius); }), Contains("refines by the spacing"));
}

TEST_CASE("Study: an error is the difference from the published value over it, with the measure's own uncertainty") {
  const Made made;
  made.run("a-4", 1.0, 0.055);
  const auto judged = made.study(by_radius);
  CHECK(judged.terms[0][0][0].truth == Approx(0.05));
  const auto points = read_points(judged, made.folder.path());
  CHECK(points.lines[0][0].failure.empty());
  CHECK(points.lines[0][0].cost == 1.0);
  CHECK(points.lines[0][0].error == Approx(0.1));
  CHECK(points.lines[0][0].error_uncertainty == Approx(0.01));
  CHECK_THAT(points.lines[0][1].failure, Contains("has not been run"));
}

TEST_CASE("Study: several errors count by their mean or by the largest") {
  const Made made;
  made.run("a-4", 1.0, 0.055);
  const auto error = by_radius + "[[error]]\nmeasure = 'symmetry_error'\n";
  CHECK(read_points(made.study(error), made.folder.path()).lines[0][0].error == Approx(0.3));
  CHECK(read_points(made.study(error, "combine = 'max'\n"), made.folder.path()).lines[0][0].error == Approx(0.5));
}

TEST_CASE("Study: what should be may be given, or be that of another variant") {
  const Made made;
  CHECK(made.study(by_radius + "variant = 'other'\nsource = 'guess'\n").terms[0][0][0].truth == Approx(0.04));
  CHECK(made.study(by_radius + "exact = '60 mm'\n").terms[0][0][0].truth == Approx(0.06));
  const auto scaled = made.study(by_radius + "exact = '0 m'\nscale = '5 mm'\n").terms[0][0][0];
  CHECK(scaled.scale == Approx(5e-3));
}

TEST_CASE("Study: page, table and answer say what was found and what failed") {
  const Made made;
  made.run("a-4", 1.0, 0.055);      // 10 %
  made.run("a-2", 10.0, 0.0505);    // 1 %
  made.run("a-1", 100.0, 0.05005);  // 0.1 %
  made.run("b-4", 0.5, 0.06);
  made.write("runs/b-2.failed", "it \"broke\"\n");
  made.write("runs/b-1/measurements.json", R"({"cpu_seconds": 1, "particles": 1, "steps": 1, "measurements": {}})");
  const auto judged = made.study(by_radius, "target = 0.02\n");
  const auto points = read_points(judged, made.folder.path());
  // 2 % lies between 10 % at 1 s and 1 % at 10 s: 10^(ln 5 / ln 10) s.
  CHECK_THAT(answer(judged, points), Contains("`a`, with 5 s of processor time") && Contains("Not reached by `b`"));
  const auto page = study_page(judged, points);
  CHECK_THAT(page, Contains("* `b-1` failed: inner_radius could not be measured"));
  CHECK_THAT(page, Contains("* `b-2` failed: it \"broke\"") && Contains("| `a` | 2 | 2 mm | 10 | 5 | 10 s | 1 % |"));
  // Radii 55, 50.5 and 50.05 mm: changes of 4.5 and 0.45 mm, order lg 10 / lg 2.
  CHECK_THAT(page, Contains("| `a` | inner_radius | 50.05 mm | 3.32 | 50 mm | ± 0.0625 mm | monotone | 50 mm |"));
  const auto csv = study_csv(judged, points);
  CHECK_THAT(csv, Contains("\nb,2,0.002,,,,,,,,,,,\"it 'broke'\"\n") && Contains("\na,4,0.004,10,5,1,"));
  for (std::size_t begin = 0; begin < csv.size();) {
    const auto end = csv.find('\n', begin);
    CHECK(std::count(csv.begin() + static_cast<long>(begin), csv.begin() + static_cast<long>(end), ',') == 13);
    begin = end + 1;
  }
  CHECK(front_of(points).size() == 4);
}

TEST_CASE("Study: where no line reaches the error, the nearest is named") {
  const Made made;
  made.run("a-4", 1.0, 0.055);
  const auto judged = made.study(by_radius);
  CHECK_THAT(answer(judged, read_points(judged, made.folder.path())),
             Contains("None reaches it") && Contains("`a` (least error 10 % at 1 s)"));
}

TEST_CASE("Study: wrong ones are refused with the place and what is allowed") {
  const Made made;
  const auto fault = [&](const std::string& error, const std::string& more = "") {
    return test::fault_of([&] { made.study(error, more); });
  };
  CHECK_THAT(fault(""), Contains("error") && Contains("missing"));
  CHECK_THAT(fault("[[error]]\nmeasure = 'crater_diameter'\n"),
             Contains("study.toml:5") && Contains("unknown name") && Contains("inner_radius"));
  CHECK_THAT(fault(by_radius + "unit = 'm'\n"), Contains("error[0].unit") && Contains("unknown key"));
  CHECK_THAT(fault(by_radius + "variant = 'other'\nsource = 'paper'\n"), Contains("0 fitting") && Contains("a guess"));
  CHECK_THAT(fault(by_radius + "exact = '3 s'\n"), Contains("length"));
  CHECK_THAT(fault(by_radius + "exact = 0\n"), Contains("a scale is needed"));
  made.write("gas.toml",
             "name = 'gas'\nspace = 'line'\nspacing = '1 mm'\n[body.gas]\nmaterial = 'air'\n"
             "[measure.error_l1_pressure]\nbody = 'gas'\n");
  CHECK_THAT(test::fault_of([&] {
               made.write("study.toml",
                          "name = 'gas'\nscene = 'gas.toml'\nresolutions = [{ factor = 1 }]\n[[error]]\nmeasure = "
                          "'error_l1_pressure'\n[line.a]\n");
               read_judged_study(made.folder.file("study.toml"));
             }),
             Contains("this norm has a unit, so a scale is needed (allowed: scale = \"... Pa\")"));
  CHECK_THAT(fault(by_radius, "combine = 'median'\n"), Contains("mean, max"));
  CHECK_THAT(fault(by_radius, "targets = 1\n"), Contains("did you mean target?"));
  CHECK_THAT(fault(by_radius, "set = ['spacing = -1']\n"), Contains("--set spacing"));
}
