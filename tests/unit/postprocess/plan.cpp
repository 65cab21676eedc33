// [measure.*], [picture.*] and references: what is accepted, and how the rest is answered.

#include "postprocess/plan.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <iostream>
#include <sstream>

#include "postprocess/pipeline.hpp"
#include "postprocess/references.hpp"
#include "support/fault.hpp"
#include "support/temporary_folder.hpp"
#include "unit/postprocess/synthetic.hpp"

namespace tektite::test {
namespace {

Plan plan_of(const std::string& tables) {
  auto document = Document::parse(scene_text(Space::plane_strain, false) + tables, "scene.toml");
  return read_plan(document);
}

void refuses(const std::string& tables, const std::vector<std::string>& words) {
  const auto fault = fault_of([&] { plan_of(tables); });
  for (const auto& word : words) {
    INFO(fault);
    CHECK(fault.find(word) != std::string::npos);
  }
}

std::vector<Reference> references_of(const std::string& text, const std::string& variant) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("reference.toml")) << text;
  return read_references(folder.file("reference.toml"), variant, plan_of("").measures);
}

}  // namespace

TEST_CASE("Plan: measures and pictures of a scene are read with their defaults") {
  const auto plan = plan_of("[picture.stress]\nfield = \"von_mises_stress\"\nrange = [0, \"0.3 GPa\"]\n");
  CHECK(plan.measures.size() == 7);
  REQUIRE(plan.pictures.size() == 1);
  CHECK(plan.pictures[0].range->second == Approx(3e8));
  CHECK(plan.pictures[0].width == 1600);
}

TEST_CASE("Plan: a measure may have a name of its own and say its type") {
  const auto plan = plan_of("[measure.hole]\ntype = \"crater_diameter\"\nbody = \"target\"\n");
  CHECK(plan.measures.back().name == "hole");
  CHECK(plan.measures.back().kind->name == "crater_diameter");
}

TEST_CASE("Plan: unknown names are answered with the known ones") {
  refuses("[measure.crater_volume]\nbody = \"target\"\n",
          {"measure.crater_volume", "crater_diameter", "peak_pressure"});
  refuses("[measure.max_temperature]\nbody = \"tarjet\"\n", {"scene.toml:", "body", "projectile, target"});
  refuses("[measure.p]\ntype = \"peak_pressure\"\nprobe = \"edge\"\n", {"measure.p.probe", "centre"});
  refuses("[picture.a]\nfield = \"presure\"\n", {"picture.a.field", "pressure", "von_mises_stress"});
  refuses("[picture.a]\nfield = \"pressure\"\nbodies = [\"plate\"]\n", {"plate", "projectile, target"});
  refuses("[picture.a]\nfield = \"pressure\"\ncolour = 1\n", {"picture.a.colour", "unknown key"});
  refuses("[picture.a]\ntype = \"film\"\n", {"particles, history"});
}

TEST_CASE("Plan: values that cannot be are refused") {
  refuses("[picture.a]\nfield = \"pressure\"\nrange = [1, 0]\n", {"must rise"});
  refuses("[picture.a]\nfield = \"pressure\"\nrange = [\"0 m\", \"1 m\"]\n", {"length", "pressure"});
  refuses("[picture.a]\nfield = \"pressure\"\nwidth = 5\n", {"out of range"});
  refuses("[picture.a]\nfield = \"pressure\"\ncut = \"z\"\n", {"picture.a.cut", "unknown key"});  // in the plane
  refuses("[picture.a]\nfield = \"pressure\"\ntimes = [\"1 m\"]\n", {"is not a time"});
  refuses("[picture.a]\nfield = \"pressure\"\nview = { lower = [0, 0], upper = [1, 0] }\n", {"must lie above"});
  refuses("[picture.\"a/b\"]\nfield = \"pressure\"\n", {"plain"});
  refuses("[measure.travel]\ntype = \"projectile_travel\"\nbody = \"target\"\naxis = [0, 0]\n", {"cannot be zero"});
}

TEST_CASE("Plan: a solid picture may be cut and turned, and what cannot be is refused") {
  const auto plan_with = [](const std::string& keys) {
    auto document = Document::parse(
        "name = \"a\"\nspace = \"solid\"\n[body.b]\n[picture.a]\nfield = \"pressure\"\n" + keys, "scene.toml");
    return read_plan(document);
  };
  const auto picture = plan_with("cut = \"x\"\ncut_at = \"2 mm\"\nfrom = [1, 0, 2]\n").pictures.front();
  CHECK(picture.cut == "x");
  CHECK(picture.cut_at == Approx(2e-3));
  CHECK((*picture.from)[2] == 2.0);
  CHECK(plan_with("").pictures.front().cut == "automatic");
  CHECK_THROWS_WITH(plan_with("cut = \"w\"\n"), Catch::Contains("automatic, none, x, y, z"));
  CHECK_THROWS_WITH(plan_with("cut_at = \"2 mm\"\n"), Catch::Contains("needs an axis"));
  CHECK_THROWS_WITH(plan_with("from = [0, 0, 0]\n"), Catch::Contains("cannot be zero"));
}

TEST_CASE("Plan: what a check tells of pictures names their type") {
  const TemporaryFolder folder;
  PostprocessOptions options;
  options.scene = folder.file("scene.toml");
  std::ofstream(options.scene) << "name = 'bar'\nspace = 'line'\n[body.bar]\n[picture.a]\ntype = 'profile'\n"
                                  "field = 'density'\n[picture.b]\nfield = 'pressure'\n";
  std::ostringstream told;
  auto* const before = std::cout.rdbuf(told.rdbuf());
  check_scene(options);
  std::cout.rdbuf(before);
  CHECK_THAT(told.str(), Catch::Contains("picture a: profile of density along x,") &&
                             Catch::Contains("picture b: pressure of the particles,"));
}

TEST_CASE("Plan: points of an exact curve are in the units of what is drawn") {
  const auto plan = plan_of(
      "[picture.a]\ntype = 'history'\ncolumns = ['centre.pressure']\n"
      "exact = [['0 us', '1 GPa'], [1e-6, 0]]\n");
  CHECK(plan.pictures.front().exact.front() == std::vector<double>{0.0, 1e9});
  refuses("[picture.a]\ntype = 'profile'\nfield = 'density'\nexact = [[0, '1 GPa'], [1, 0]]\n",
          {"picture.a.exact", "this is a pressure", "density"});
}

TEST_CASE("References: entries hold for their variants, with what they allow") {
  const std::string text =
      "[[reference]]\nmeasure = \"crater_diameter\"\nvariant = \"a\"\npublished = \"2.1 cm\"\nwithin = \"1 mm\"\n"
      "source = \"x\"\n[[reference]]\nmeasure = \"peak_pressure\"\nvariants = [\"a\", \"b\"]\n"
      "published = \"10 GPa\"\nwithin_relative = 0.03\nsource = \"y\"\n"
      "[[reference]]\nmeasure = \"energy_drift\"\npublished = 0\nsource = \"z\"\n";
  const auto of_a = references_of(text, "a");
  REQUIRE(of_a.size() == 3);
  CHECK(of_a[0].published == Approx(0.021));
  CHECK(*of_a[0].within == Approx(1e-3));
  CHECK(*of_a[1].within == Approx(3e8));
  CHECK_FALSE(of_a[2].within);
  CHECK(references_of(text, "b").size() == 2);
  CHECK(references_of(text, "").size() == 1);
}

TEST_CASE("References: what is wrong is told with its place") {
  const auto fault = fault_of([] {
    references_of("[[reference]]\nmeasure = \"crater_diameter\"\npublished = \"2.1 Pa\"\nsource = \"x\"\n", "");
  });
  CHECK(fault.find("reference.toml:3") != std::string::npos);
  CHECK(fault.find("length") != std::string::npos);
  CHECK(fault_of([] {
          references_of("[[reference]]\nmeasure = \"size\"\npublished = 1\nsource = \"x\"\n", "");
        }).find("crater_diameter") != std::string::npos);
  CHECK(fault_of([] {
          references_of(
              "[[reference]]\nmeasure = \"crater_diameter\"\npublished = \"2.1 cm\"\nsource = \"x\"\n"
              "within = \"1 mm\"\nwithin_relative = 0.05\n",
              "");
        }).find("within is given too") != std::string::npos);
}

}  // namespace tektite::test
