// Pictures are drawn, show what they should, and their absence is told.

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "core/write_beside.hpp"
#include "postprocess/render/canvas.hpp"
#include "postprocess/render/chart.hpp"
#include "postprocess/render/cost_chart.hpp"
#include "postprocess/render/draw.hpp"
#include "support/apart.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"
#include "unit/postprocess/colours.hpp"
#include "unit/postprocess/synthetic.hpp"

namespace tektite::test {
namespace {

struct Made {
  TemporaryFolder folder;
  RunFolder run;
  Scene scene;
  Event event;
  std::vector<Measurement> measurements;

  explicit Made(Space space) {
    scene.name = "made_by_hand";
    scene.title = "Disc through a plate";
    scene.space = space;
    const Ending ending{12e-3, 0.0, 20e-3, true};
    run.path = folder.path();
    run.snapshots = {folder.file("snapshots/000000.h5")};
    event.last_snapshot = snapshot_of(space, impact(space, &ending, false), 8e-6, "", as_it_is);
    event.last = make_whole(event.last_snapshot, {});
    measurements = {{"crater_diameter", "m", {12e-3, 8e-6, 1e-3, Segment{{1e-3, -6e-3, 0}, {1e-3, 6e-3, 0}}}}};
  }
  std::vector<std::string> draw(const Picture& picture) {
    return draw_pictures({picture}, {run, scene, event, measurements});
  }
};

Picture small_picture(const std::string& field) {
  Picture picture;
  picture.name = field;
  picture.field = field;
  picture.width = 640;
  picture.height = 400;
  return picture;
}

}  // namespace

TEST_CASE("Pictures: particles are drawn in many colours on white, in the plane and in space") {
  for (const auto space : {Space::plane_strain, Space::solid}) {
    Made made(space);
    const auto told = made.draw(small_picture("pressure"));
    const auto path = made.folder.file("pictures/pressure.png");
    REQUIRE(told == std::vector<std::string>{"picture: " + path});
    const auto colours = colours_of(path);
    CHECK(colours.size() > 200);
    CHECK(colours.at({255, 255, 255}) > 640 * 400 / 4);
    CHECK(colours.at({255, 255, 255}) < 640 * 400 * 98 / 100);  // the crumbs far ahead make the bodies small
  }
}

TEST_CASE("Pictures: bodies have distinct colours, and an undeformed body shows no holes") {
  Made made(Space::plane_strain);
  auto picture = small_picture("body");
  picture.view = Region{{1e-4, 8e-3}, {1.9e-3, 18e-3}};  // inside the plate, beyond its hole
  picture.measures = false;
  REQUIRE(made.draw(picture).size() == 1);
  const auto colours = colours_of(made.folder.file("pictures/body.png"));
  // The plate is 10 mm of the height of the view and as wide as 2 mm of it; every pixel of that is its colour.
  const Colour blue{0, 115, 179};
  const double pixels_per_metre = 0.81 * 400 / (1.04 * 10e-3);
  REQUIRE(colours.contains(blue));
  CHECK(colours.at(blue) > 0.95 * 2e-3 * pixels_per_metre * 0.81 * 400);
}

TEST_CASE("Pictures: a legend of more bodies than there is room for says how many are left out") {
  // Colours in the lower right corner, where the legend of 40 bodies would leave the picture.
  const auto corner = [](int bodies) {
    Made made(Space::plane_strain);
    std::vector<Placed> placed;
    for (int k = 0; k < bodies; ++k) placed.push_back({"b" + std::to_string(k), {k * spacing, 0.0, 0.0}, {}});
    made.event.last_snapshot = snapshot_of(Space::plane_strain, placed, 8e-6, "", as_it_is);
    made.event.last = make_whole(made.event.last_snapshot, {});
    made.measurements.clear();
    REQUIRE(made.draw(small_picture("body")).size() == 1);
    return colours_of(made.folder.file("pictures/body.png"), {550, 0, 640, 25}).size();
  };
  CHECK(corner(8) == 1);
  CHECK(corner(40) == 1);
}

TEST_CASE("Pictures: kernel types have their own two colours, whichever of them there are") {
  Made made(Space::plane_strain);
  made.event.last_snapshot.particles.allocate(Field::kernel_type);
  for (auto& type : made.event.last_snapshot.particles.integers(Field::kernel_type).first(80)) type = 1;
  REQUIRE(made.draw(small_picture("kernel_type")).size() == 1);
  auto colours = colours_of(made.folder.file("pictures/kernel_type.png"));
  const Colour dark{51, 84, 153};
  const Colour light{250, 199, 102};
  CHECK(colours[dark] > 100);
  CHECK(colours[light] > 100);
  for (auto& type : made.event.last_snapshot.particles.integers(Field::kernel_type)) type = 1;
  REQUIRE(made.draw(small_picture("kernel_type")).size() == 1);
  auto eulerian = colours_of(made.folder.file("pictures/kernel_type.png"));
  CHECK(eulerian[light] > colours[light]);
  CHECK(eulerian[dark] > 0);  // the legend names both
  CHECK(eulerian[dark] < colours[dark]);
}

TEST_CASE("Pictures: one drawn after others of another size and field is the one that is drawn alone") {
  Made made(Space::plane_strain);
  auto large = small_picture("pressure");
  large.width = 800;
  large.height = 600;
  const auto small = small_picture("speed");
  const auto contents = [&] {
    std::vector<std::string> files;
    for (const auto* name : {"pressure", "speed", "body"})
      files.push_back(content_of(made.folder.file(std::string("pictures/") + name + ".png")));
    return files;
  };
  for (const auto& picture : {large, small, small_picture("body")}) REQUIRE(made.draw(picture).size() == 1);
  const auto alone = contents();
  std::filesystem::remove_all(made.folder.file("pictures"));
  REQUIRE(draw_pictures({large, small, small_picture("body")}, {made.run, made.scene, made.event, made.measurements})
              .size() == 3);
  CHECK(contents() == alone);
}

TEST_CASE("Pictures: a cut through a solid takes away one half of it") {
  Made made(Space::solid);
  auto picture = small_picture("body");
  picture.bodies = {"target"};
  picture.measures = false;
  picture.from = Point{1.0, 0.0, 0.0};
  picture.view = Region{{-2e-3, -20e-3, -20e-3}, {4e-3, 20e-3, 20e-3}};
  const auto covered = [&](const std::string& cut) {
    picture.cut = cut;
    REQUIRE(made.draw(picture).size() == 1);
    return 640 * 400 - colours_of(made.folder.file("pictures/body.png")).at({255, 255, 255});
  };
  // What is written on the picture covers a few per cent as well and stays.
  const int whole = covered("none");
  CHECK(covered("y") > 0.5 * whole);
  CHECK(covered("y") < 0.6 * whole);
}

TEST_CASE("Pictures: on a half model a velocity has its sign turned behind the symmetry plane") {
  Made made(Space::plane_strain);
  auto placed = impact(Space::plane_strain, nullptr, true);
  for (auto& particle : placed) particle.velocity = {0.0, 100.0, 0.0};
  made.event.last_snapshot = snapshot_of(Space::plane_strain, placed, 8e-6, "", as_it_is);
  made.scene.symmetry = {{1, 0.0, 1.0}};
  auto picture = small_picture("velocity_y");
  picture.measures = false;
  REQUIRE(made.draw(picture).size() == 1);
  // Two areas of one colour each: the upper and the lower half.
  const auto colours = colours_of(made.folder.file("pictures/velocity_y.png"));
  CHECK(std::ranges::count_if(colours, [](const auto& entry) {
          return entry.first != Colour{255, 255, 255} && entry.second > 640 * 400 / 100;
        }) == 2);
}

TEST_CASE("Pictures: a column has the unit of its field, whichever component it is") {
  CHECK(unit_of_column("centre.deviatoric_stress_xx") == "Pa");
  CHECK(unit_of_column("centre.deviatoric_stress_xy") == "Pa");
  CHECK(unit_of_column("centre.velocity_x") == "m/s");
  CHECK(unit_of_column("centre.smoothing_length") == "m");
  CHECK(unit_of_column("centre.damage") == "1");
}

TEST_CASE("Pictures: energy and momentum of a plane are those of a slice, of rings they are whole") {
  CHECK(slice_of("J", Space::plane_stress) == " (per metre of thickness)");
  CHECK(slice_of("kg m/s", Space::plane_strain) == " (per metre of thickness)");
  CHECK(slice_of("Pa", Space::plane_strain).empty());
  CHECK(slice_of("J", Space::axisymmetric).empty());
}

TEST_CASE("Pictures: a history is drawn with one line a column") {
  Made made(Space::plane_strain);
  std::ofstream(made.folder.file("history.csv")) << "time,kinetic_energy,internal_energy\n0,10,0\n1e-6,6,4\n2e-6,5,5\n";
  made.run.history = History::read(made.folder.file("history.csv"));
  auto picture = small_picture("");
  picture.name = "energy";
  picture.type = PictureType::history;
  picture.columns = {"kinetic_energy", "internal_energy"};
  REQUIRE(made.draw(picture) == std::vector<std::string>{"picture: " + made.folder.file("pictures/energy.png")});
  const auto colours = colours_of(made.folder.file("pictures/energy.png"));
  CHECK(colours.contains(Colour{230, 158, 0}));
  CHECK(colours.contains(Colour{0, 115, 179}));
}

TEST_CASE("Pictures: what cannot be drawn is a warning") {
  Made made(Space::plane_strain);
  const auto absent = made.draw(small_picture("temperature"));
  REQUIRE(absent.size() == 1);
  CHECK(absent[0].find("warning: no picture temperature") != std::string::npos);
  auto profile = small_picture("temperature");
  profile.type = PictureType::profile;
  CHECK(made.draw(profile)[0].find("warning: no picture temperature: the snapshot at 8e-06 s has no temperature") == 0);
  auto picture = small_picture("");
  picture.name = "mixed";
  picture.type = PictureType::history;
  picture.columns = {"time", "kinetic_energy"};
  std::ofstream(made.folder.file("history.csv")) << "time,kinetic_energy\n0,10\n";
  made.run.history = History::read(made.folder.file("history.csv"));
  CHECK(made.draw(picture)[0].find("a picture each") != std::string::npos);
  made.run.history.reset();
  CHECK(made.draw(picture)[0].find("there is no history.csv") != std::string::npos);
  auto nobody = small_picture("pressure");
  nobody.bodies = {"nobody"};
  CHECK(made.draw(nobody)[0].find("there is no particle to draw") != std::string::npos);
}

TEST_CASE("Pictures: one that cannot be written is told, and no half of it is left") {
  Made made(Space::plane_strain);
  const auto path = made.folder.file("pictures/pressure.png");
  std::filesystem::create_directories(path + std::string(part_ending) + "/in_the_way");
  const auto told = made.draw(small_picture("pressure"));
  REQUIRE(told.size() == 1);
  CHECK_THAT(told[0], Catch::StartsWith("warning: no picture pressure: " + path + ": cannot be written"));

  const auto full = fault_apart([&] {
    const Canvas canvas(640, 400);
    leave_room(300);
    canvas.write_png(made.folder.file("full.png"));
  });
  CHECK_THAT(full, Catch::Contains(made.folder.file("full.png") + ": cannot be written"));
  CHECK_FALSE(std::filesystem::exists(made.folder.file("full.png")));
  CHECK_FALSE(std::filesystem::exists(made.folder.file("full.png") + std::string(part_ending)));
}

TEST_CASE("Pictures: those of a run need no X server, and where a chart of a study finds none, that is said") {
  Made made(Space::plane_strain);
  const std::string path = std::getenv("PATH");
  setenv("PATH", made.folder.path().c_str(), 1);
  const auto told = made.draw(small_picture("pressure"));
  const auto told_of_chart = draw_cost_chart({"a study", {}, {}}, made.folder.file("chart"));
  setenv("PATH", path.c_str(), 1);
  CHECK(told == std::vector<std::string>{"picture: " + made.folder.file("pictures/pressure.png")});
  REQUIRE(told_of_chart.size() == 1);
  CHECK(told_of_chart[0].find("Xvfb") != std::string::npos);
}

}  // namespace tektite::test
