// The stage from end to end, without pictures: what it leaves in the folder of a run.

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "postprocess/pipeline.hpp"
#include "postprocess/report.hpp"
#include "support/fault.hpp"
#include "support/temporary_folder.hpp"
#include "unit/postprocess/synthetic.hpp"

namespace tektite::test {
namespace {

namespace fs = std::filesystem;

constexpr Ending perforated{12e-3, 0.0, 20e-3, true};

void write_run(const TemporaryFolder& folder) {
  const auto text = scene_text(Space::plane_strain, false) + "#@ variant fast\n";
  const auto space = Space::plane_strain;
  write_snapshot(snapshot_of(space, impact(space, nullptr, false), 0.0, text, as_it_is),
                 folder.file("snapshots/000000.h5"));
  write_snapshot(snapshot_of(space, impact(space, &perforated, false), 8e-6, text, as_it_is),
                 folder.file("snapshots/000001.h5"));
  std::ofstream(folder.file("history.csv")) << "step,time,centre.pressure\n0,0,0\n1,4e-6,2e9\n2,8e-6,1e9\n";
  std::ofstream(folder.file("solve.json")) << R"({"steps": 2, "scheme": "eulerian", "contact_time": 1e-6,
    "energy_drift": 1e-4, "momentum_drift": 0.0, "threads": 2})";
}

PostprocessOptions numbers_only(const std::string& path) {
  PostprocessOptions options;
  options.run = path;
  options.pictures = false;
  return options;
}

nlohmann::json json_of(const std::string& path) {
  std::ifstream file(path);
  return nlohmann::json::parse(file);
}

}  // namespace

TEST_CASE("Files: measurements.json holds summary, measurements and references with their differences") {
  const TemporaryFolder folder;
  write_run(folder);
  std::ofstream(folder.file("reference.toml"))
      << "[[reference]]\nmeasure = \"crater_diameter\"\nvariant = \"fast\"\npublished = \"10 mm\"\nwithin = \"3 mm\"\n"
         "source = \"by hand\"\n[[reference]]\nmeasure = \"energy_drift\"\npublished = 0\nwithin = 1e-5\n"
         "source = \"by hand\"\n[[reference]]\nmeasure = \"peak_tension\"\nvariant = \"slow\"\npublished = 1\n"
         "source = \"not ours\"\n";
  auto options = numbers_only(folder.path());
  options.reference = folder.file("reference.toml");
  postprocess(options);

  const auto file = json_of(folder.file("measurements.json"));
  CHECK(file["scene"] == "made_by_hand");
  CHECK(file["variant"] == "fast");
  CHECK(file["scheme"] == "eulerian");
  CHECK(file["steps"] == 2);
  CHECK(file["time"] == 8e-6);
  CHECK(file["energy_drift"] == 1e-4);
  const auto& crater = file["measurements"]["crater_diameter"];
  CHECK(crater["value"].get<double>() == Approx(12e-3));
  CHECK(crater["unit"] == "m");
  CHECK(crater["time"] == 8e-6);
  CHECK(crater["uncertainty"].get<double>() >= spacing);
  CHECK(file["measurements"]["peak_pressure"]["value"] == 2e9);
  REQUIRE(file["references"].size() == 2);
  CHECK(file["references"][0]["difference"].get<double>() == Approx(0.2));
  CHECK(file["references"][0]["within"] == true);
  CHECK(file["references"][1]["difference"].is_null());
  CHECK(file["references"][1]["within"] == false);
}

TEST_CASE("Files: the table and measurements.json tell the same difference from a negative published value") {
  const TemporaryFolder folder;
  const RunFolder run;
  Report report;
  report.measurements = {{"min_pressure", "Pa", {-0.8e9, 8e-6, 1e7, {}}}};
  report.references = {{"min_pressure", "by hand", "Pa", -1e9, {}}};
  write_measurements(report, run, folder.file("measurements.json"));
  CHECK(json_of(folder.file("measurements.json"))["references"][0]["difference"].get<double>() == Approx(0.2));
  CHECK_THAT(comparison_table(report, run), Catch::Contains("+20.0 %"));
}

TEST_CASE("Files: a scene without measures is told so in place of an empty table") {
  CHECK(comparison_table({}, {}) == "nothing measured: the scene has no [measure.NAME]\n");
}

TEST_CASE("Files: each snapshot becomes a VTU, the collection and the fragments are there") {
  const TemporaryFolder folder;
  write_run(folder);
  postprocess(numbers_only(folder.path()));
  CHECK(fs::exists(folder.file("vtu/000000.vtu")));
  CHECK(fs::exists(folder.file("vtu/000001.vtu")));
  CHECK(fs::exists(folder.file("made_by_hand.pvd")));
  std::ifstream fragments(folder.file("fragments.csv"));
  std::string header;
  std::getline(fragments, header);
  CHECK(header == "fragment,body,particles,mass,centre_x,centre_y,velocity_x,velocity_y");
  std::string first;
  std::getline(fragments, first);
  CHECK(first.starts_with("0,projectile,"));
}

TEST_CASE("Files: initial particles alone are shown, and measures that need more are told as missing") {
  const TemporaryFolder folder;
  const auto space = Space::plane_strain;
  write_snapshot(snapshot_of(space, impact(space, nullptr, false), 0.0, scene_text(space, false), as_it_is),
                 folder.file("particles.h5"));
  postprocess(numbers_only(folder.path()));
  const auto file = json_of(folder.file("measurements.json"));
  CHECK(file["measurements"].contains("projectile_extension"));
  CHECK_FALSE(file["measurements"].contains("peak_pressure"));
  CHECK(fs::exists(folder.file("vtu/particles.vtu")));
}

TEST_CASE("Files: one particle file is shown in a folder of its name") {
  const TemporaryFolder folder;
  write_run(folder);
  postprocess(numbers_only(folder.file("snapshots/000001.h5")));
  CHECK(fs::exists(folder.file("snapshots/000001/measurements.json")));
}

TEST_CASE("Files: another scene gives other measures without computing again") {
  const TemporaryFolder folder;
  write_run(folder);
  std::ofstream(folder.file("other.toml"))
      << "name = \"made_by_hand\"\nspace = \"plane-strain\"\n[body.target]\n[variant.fast.measure.max_plastic_strain]\n"
         "body = \"target\"\n";
  auto options = numbers_only(folder.path());
  options.scene = folder.file("other.toml");
  options.variant = "fast";
  postprocess(options);
  const auto file = json_of(folder.file("measurements.json"));
  CHECK(file["measurements"].size() == 1);
  CHECK(file["measurements"].contains("max_plastic_strain"));
}

TEST_CASE("Files: a folder without particles, a broken summary and a broken history are refused") {
  const TemporaryFolder folder;
  CHECK(fault_of([&] { postprocess(numbers_only(folder.path())); }).find("holds no particles") != std::string::npos);
  CHECK(fault_of([&] { postprocess(numbers_only(folder.file("none"))); }).find("no such folder") != std::string::npos);
  write_run(folder);
  std::ofstream(folder.file("solve.json")) << "{\"steps\": ";
  CHECK(fault_of([&] { postprocess(numbers_only(folder.path())); }).find("not a JSON object") != std::string::npos);
  write_run(folder);
  std::ofstream(folder.file("history.csv")) << "step,time\n0,0,0\n";
  CHECK(fault_of([&] { postprocess(numbers_only(folder.path())); }).find("history.csv:2") != std::string::npos);
}

}  // namespace tektite::test
