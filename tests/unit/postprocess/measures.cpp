// Every measure on runs made by hand, in several orientations, whole and half: the values are known, and the same.

#include <catch2/catch.hpp>
#include <fstream>

#include "core/error.hpp"
#include "postprocess/plan.hpp"
#include "support/temporary_folder.hpp"
#include "unit/postprocess/synthetic.hpp"

namespace tektite::test {
namespace {

struct Case {
  Space space = Space::plane_strain;
  Ending ending;
  bool half = false;
  Turn turn = as_it_is;
  std::optional<double> contact_time;
};

Event event_of(const Case& of) {
  auto document = Document::parse(scene_text(of.space, of.half), "scene.toml");
  const auto planes = read_plan(document).scene.symmetry;
  const auto first = snapshot_of(of.space, impact(of.space, nullptr, of.half), 0.0, "", of.turn);
  Event event;
  event.last_snapshot = snapshot_of(of.space, impact(of.space, &of.ending, of.half), 8e-6, "", of.turn);
  event.initial = make_whole(first, planes);
  event.last = make_whole(event.last_snapshot, planes);
  event.fragments = find_fragments(event.last, link_of_support);
  event.narrow_fragments = find_fragments(event.last, link_of_smoothing_length);
  event.contact_time = of.contact_time;
  return event;
}

Measured take(const std::string& name, const Event& event, Space space = Space::plane_strain,
              const std::vector<std::string>& settings = {}) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("scene.toml")) << scene_text(space, false);
  auto document = Document::load(folder.file("scene.toml"), {}, settings);
  for (const auto& measure : read_plan(document).measures)
    if (measure.name == name) return taken(measure, event);
  throw std::logic_error("no measure " + name);
}

/// The same case as it is, turned and mirrored; and as a half where its symmetry allows that.
std::vector<Case> orientations(const Case& of) {
  std::vector<Case> cases(5, of);
  cases[1].turn = turned_by_90_degrees;
  cases[2].turn = turned_by_30_degrees;
  cases[3].turn = mirrored;
  cases[4].half = true;
  return cases;
}

}  // namespace

TEST_CASE("Extension: a disc that stays whole has its diameter, in every orientation") {
  for (const auto& of : orientations({Space::plane_strain, {0.0, 0.0, 0.0, false}, false, as_it_is, {}})) {
    const auto measured = take("projectile_extension", event_of(of));
    CHECK(measured.value == Approx(10e-3).epsilon(1e-9));
    CHECK(measured.uncertainty == Approx(spacing).epsilon(1e-9));
    CHECK(measured.time == 8e-6);
  }
}

TEST_CASE("Extension and travel: loose crumbs far ahead do not count") {
  for (const auto& of : orientations({Space::plane_strain, {12e-3, 0.0, 20e-3, true}, false, as_it_is, {}})) {
    const auto event = event_of(of);
    REQUIRE(std::count_if(event.fragments.list.begin(), event.fragments.list.end(),
                          [](const Fragment& fragment) { return fragment.body == 0; }) > 1);
    CHECK(take("projectile_extension", event).value == Approx(10e-3).epsilon(1e-9));
    CHECK(take("projectile_travel", event).value == Approx(26e-3).epsilon(1e-9));
  }
}

TEST_CASE("Crater: it is as wide where the target moves too, and is drawn where that has come to") {
  const Case of{Space::plane_strain, {12e-3, 0.0, 20e-3, false}, false, as_it_is, {}};
  const auto at_rest = event_of(of);
  auto moving = at_rest;
  const Point velocity{-700.0, 300.0, 0.0}, way = (moving.last.time - moving.initial.time) * velocity;
  for (auto* whole : {&moving.initial, &moving.last})
    for (auto& v : whole->velocity) v += velocity;
  for (auto& x : moving.last.position) x += way;
  const auto here = take("crater_diameter", at_rest), there = take("crater_diameter", moving);
  CHECK(there.value == Approx(here.value).epsilon(1e-9));
  CHECK(there.uncertainty == Approx(here.uncertainty).epsilon(1e-9));
  CHECK(norm(there.drawing->from - (here.drawing->from + way)) < 1e-9);
}

TEST_CASE("Travel: counts from where the leading edge was at contact") {
  Case of{Space::plane_strain, {0.0, 0.0, 20e-3, false}, false, turned_by_90_degrees, 1e-6};
  CHECK(take("projectile_travel", event_of(of)).value == Approx(25e-3).epsilon(1e-9));
}

TEST_CASE("Travel: a body at rest has no direction of flight, and the message says so") {
  auto event = event_of({});
  for (auto& velocity : event.initial.velocity) velocity = Point::zero();
  CHECK_THROWS_WITH(take("projectile_travel", event), Catch::Contains("give the measure an axis"));
}

// The innermost particle tells each edge to half a spacing; a diameter is known to half a spacing where both agree.
TEST_CASE("Crater: the hole in a plate has the diameter that was cut out, in every orientation") {
  for (const auto& of : orientations({Space::plane_strain, {12e-3, 0.0, 30e-3, false}, false, as_it_is, {}})) {
    const auto measured = take("crater_diameter", event_of(of));
    CHECK(measured.value == Approx(12e-3).margin(0.5 * spacing));
    REQUIRE(measured.drawing);
    CHECK(norm(measured.drawing->to - measured.drawing->from) == Approx(measured.value).epsilon(1e-9));
  }
}

TEST_CASE("Crater, extension and travel: a moving observer measures the same") {
  // The plate flies against the disc, to the side, or after it.
  const auto event = event_of({Space::plane_strain, {12e-3, 0.0, 30e-3, false}, false, as_it_is, 1e-6});
  for (const auto& velocity : {Point{-1000.0, 0.0, 0.0}, {0.0, 2000.0, 0.0}, {5000.0, -300.0, 0.0}})
    for (const std::string name : {"crater_diameter", "projectile_extension", "projectile_travel"}) {
      INFO(name);
      const auto seen = take(name, carried_along(event, velocity)), at_rest = take(name, event);
      CHECK(seen.value == Approx(at_rest.value).epsilon(1e-9));
      // The line is drawn where the bodies are seen; that of the travel stays on the flight line of the start.
      const auto way = event.last.time * velocity, apart = seen.drawing->from - at_rest.drawing->from - way;
      CHECK((name == "projectile_travel" ? std::abs(apart[0]) : norm(apart)) < 1e-9);
    }
}

TEST_CASE("Crater: crumbs that hang in the hole do not close it") {
  const auto event = event_of({Space::plane_strain, {12e-3, 0.0, 30e-3, true}, false, as_it_is, {}});
  CHECK(take("crater_diameter", event).value == Approx(12e-3).margin(0.5 * spacing));
}

TEST_CASE("Crater: a pit that does not go through is measured at the original front surface") {
  for (const auto& of : orientations({Space::plane_strain, {0.0, 8e-3, -20e-3, false}, false, as_it_is, {}}))
    CHECK(take("crater_diameter", event_of(of)).value == Approx(8e-3).margin(0.5 * spacing));
}

// What is left of the plate is bent back but for its edge: within 8 mm of the flight line it lies behind the original
// front surface, from there to 16 mm before it, each linked to the other, and none within one spacing of the surface.
TEST_CASE("Crater: a sheet that crosses the original front surface between its particles is seen there") {
  for (auto of : orientations({Space::plane_strain, {12e-3, 0.0, 30e-3, false}, false, as_it_is, {}})) {
    auto event = event_of(of);
    const auto along = of.turn({1.0, 0.0, 0.0});
    const auto target = event.last.body_named("target");
    for (std::size_t i = 0; i < event.last.count(); ++i) {
      const auto start = event.initial.position[i];
      const double radius = norm(start - dot(start, along) * along);
      if (event.last.body[i] != target || radius < 6e-3 || radius > 16e-3) continue;
      event.last.position[i] += (radius < 8e-3 ? 1.0e-3 : -1.7e-3) * along;
    }
    event.fragments = find_fragments(event.last, link_of_support);
    event.narrow_fragments = event.fragments;
    CHECK(take("crater_diameter", event).value == Approx(16e-3).epsilon(1e-9));
  }
}

TEST_CASE("Crater: a target that was not touched has none") {
  const auto event = event_of({});
  CHECK(take("crater_diameter", event).value <= spacing);
}

TEST_CASE(
    "Crater: a pit is as deep as what was cut out of it, in every orientation, and an untouched target has none") {
  for (const auto space : {Space::plane_strain, Space::solid})
    for (const auto& of : orientations({space, {0.0, 8e-3, -20e-3, false}, false, as_it_is, {}})) {
      const auto measured = take("crater_depth", event_of(of), space);
      CHECK(measured.value == Approx(spacing).epsilon(1e-9));
      CHECK(measured.uncertainty == Approx(spacing).epsilon(1e-9));
      CHECK(norm(measured.drawing->to - measured.drawing->from) == Approx(spacing).epsilon(1e-9));
    }
  CHECK(std::abs(take("crater_depth", event_of({})).value) < 1e-12);
}

TEST_CASE("Crater: an axis is a line, whose sense is that of the flight") {
  const auto event = event_of({Space::plane_strain, {0.0, 8e-3, -20e-3, false}, false, as_it_is, {}});
  for (const std::string axis : {"[1, 0]", "[-1, 0]"})
    CHECK(take("crater_depth", event, Space::plane_strain, {"measure.crater_depth.axis=" + axis}).value ==
          Approx(spacing).epsilon(1e-9));
}

TEST_CASE("Crater: of an oblique impact it is measured along the axis that is given, about the place that is struck") {
  // The plate with its pit is moved sideways, and the disc flies so that its centre comes to the middle of the pit.
  for (const auto space : {Space::plane_strain, Space::solid}) {
    auto event = event_of({space, {0.0, 8e-3, -20e-3, false}, false, as_it_is, {}});
    for (auto* whole : {&event.initial, &event.last})
      for (std::size_t i = 0; i < whole->count(); ++i)
        if (whole->body[i] == whole->body_named("target")) whole->position[i][1] += 6e-3;
    for (std::size_t i = 0; i < event.initial.count(); ++i)
      if (event.initial.body[i] == event.initial.body_named("projectile"))
        event.initial.velocity[i] = {1000.0, 1000.0, 0.0};
    const std::string axis = space == Space::solid ? "axis=[1,0,0]" : "axis=[1,0]";
    CHECK(take("crater_depth", event, space, {"measure.crater_depth." + axis}).value == Approx(spacing).epsilon(1e-9));
    CHECK(take("crater_diameter", event, space, {"measure.crater_diameter." + axis}).value ==
          Approx(8e-3).margin(0.5 * spacing));
    // Along the flight the plate's corner would be taken for its front.
    for (const std::string name : {"crater_depth", "crater_diameter"})
      CHECK_THROWS_WITH(take(name, event, space), Catch::Contains("the target's front face does not lie across"));
  }
}

TEST_CASE("Crater: the depth of a channel that is slender beside the kernel is that of its floor") {
  // Its walls, two spacings off, lie within the support of the flight line, and the uncertainty says so.
  const auto measured =
      take("crater_depth", event_of({Space::plane_strain, {0.0, 4e-3, -20e-3, false}, false, as_it_is, {}}));
  CHECK(measured.value == Approx(spacing).epsilon(1e-9));
  CHECK(measured.uncertainty == Approx(2.0 * spacing).epsilon(1e-9));
}

TEST_CASE("Crater: a perforated target has no depth, and the message says so; a moving observer measures the same") {
  const auto through = event_of({Space::plane_strain, {12e-3, 0.0, 30e-3, true}, false, as_it_is, {}});
  CHECK_THROWS_WITH(take("crater_depth", through), Catch::Contains("perforated"));
  auto beside = event_of({});
  for (auto* whole : {&beside.initial, &beside.last})
    for (std::size_t i = 0; i < whole->count(); ++i)
      if (whole->body[i] == whole->body_named("target")) whole->position[i][1] += 0.1;
  CHECK_THROWS_WITH(take("crater_depth", beside), Catch::Contains("passes the target by"));
  const auto pit = event_of({Space::plane_strain, {0.0, 8e-3, -20e-3, false}, false, as_it_is, 1e-6});
  CHECK(take("crater_depth", carried_along(pit, {-1000.0, 200.0, 0.0})).value == Approx(spacing).epsilon(1e-9));
}

TEST_CASE("Crater: a round hole in space has its diameter to within a spacing, in every orientation") {
  for (const auto& of : orientations({Space::solid, {12e-3, 0.0, 30e-3, false}, false, as_it_is, {}})) {
    const auto measured = take("crater_diameter", event_of(of), Space::solid);
    // The rim of a hole that is cut out of a lattice is rough by a spacing.
    CHECK(std::abs(measured.value - 12e-3) < spacing);
    CHECK(measured.uncertainty >= spacing);
  }
}

TEST_CASE("Crater: where nothing of the target is left behind its front surface, that is told") {
  auto event = event_of({Space::plane_strain, {12e-3, 0.0, 30e-3, false}, false, as_it_is, {}});
  for (std::size_t i = 0; i < event.last.count(); ++i) event.last.position[i][0] -= 1.0;
  CHECK_THROWS_AS(take("crater_diameter", event), RunError);
}

TEST_CASE("Peaks: value and time of the largest pressure and tension that a probe saw") {
  const TemporaryFolder folder;
  std::ofstream(folder.file("history.csv")) << "step,time,centre.pressure\n0,0,0\n1,1e-7,4e9\n2,2e-7,19e9\n"
                                               "3,3e-7,18e9\n4,4e-7,-2e9\n5,5e-7,-1e9\n";
  auto event = event_of({});
  event.history = History::read(folder.file("history.csv"));
  const auto pressure = take("peak_pressure", event);
  CHECK(pressure.value == 19e9);
  CHECK(pressure.time == 2e-7);
  CHECK(pressure.uncertainty == Approx(0.5 * (19e9 - 4e9)));
  const auto tension = take("peak_tension", event);
  CHECK(tension.value == 2e9);
  CHECK(tension.time == 4e-7);
}

TEST_CASE("Peaks: from a time on, which counts from the first contact") {
  const TemporaryFolder folder;
  std::ofstream(folder.file("history.csv")) << "step,time,centre.pressure\n0,0,0\n1,1e-7,-9e9\n2,2e-7,-2e9\n"
                                               "3,3e-7,-3e9\n4,4e-7,-1e9\n";
  auto event = event_of({});
  event.history = History::read(folder.file("history.csv"));
  event.contact_time = 0.5e-7;
  const auto tension = take("peak_tension", event, Space::plane_strain, {"measure.peak_tension.from='0.1 us'"});
  CHECK(tension.value == 3e9);
  CHECK(tension.time == 3e-7);
  CHECK_THROWS_WITH(take("peak_tension", event, Space::plane_strain, {"measure.peak_tension.from='1 us'"}),
                    Catch::Contains("the run ends before the 1.05e-06 s from which it is looked for"));
}

TEST_CASE("Peaks: the uncertainty looks as far as sound takes across half a spacing") {
  // 0.5 mm at 5000 m/s is 0.1 µs: samples 0.05 µs apart are looked at two to each side.
  const TemporaryFolder folder;
  std::ofstream(folder.file("history.csv")) << "time,centre.pressure\n0,1e9\n0.05e-6,6e9\n0.1e-6,9e9\n0.15e-6,10e9\n"
                                               "0.2e-6,9.5e9\n0.24e-6,8e9\n";
  auto event = event_of({});
  event.history = History::read(folder.file("history.csv"));
  CHECK(take("peak_pressure", event).uncertainty == Approx(0.5 * (10e9 - 6e9)));
}

TEST_CASE("Peaks: without a history or without the probe's column the reason is told") {
  auto event = event_of({});
  CHECK_THROWS_WITH(take("peak_pressure", event), Catch::Contains("history.csv"));
  const TemporaryFolder folder;
  std::ofstream(folder.file("history.csv")) << "time\n0\n";
  event.history = History::read(folder.file("history.csv"));
  CHECK_THROWS_WITH(take("peak_pressure", event), Catch::Contains("centre.pressure"));
  std::ofstream(folder.file("history.csv")) << "time,centre.pressure\n";
  event.history = History::read(folder.file("history.csv"));
  CHECK_THROWS_WITH(take("peak_pressure", event), Catch::Contains("history.csv has no rows"));
}

TEST_CASE("Extremes: the largest plastic strain of a body, and how much it stands out") {
  auto event = event_of({});
  auto strain = event.last_snapshot.particles.reals(Field::plastic_strain);
  const auto body = event.last_snapshot.particles.bodies()[1].range;
  for (auto& value : strain) value = 9.0;  // of the projectile, which must not count
  for (auto i = body.begin; i < body.end; ++i) strain[i] = 0.1;
  strain[body.begin + 20] = 0.5;
  const auto measured = take("max_plastic_strain", event);
  CHECK(measured.value == 0.5);
  CHECK(measured.uncertainty > 0.2);
  CHECK(measured.uncertainty < 0.4);
}

TEST_CASE("Measures: every kind has a reader and a name of its own") {
  std::set<std::string> names;
  for (const auto& kind : measure_kinds()) {
    CHECK(kind.read != nullptr);
    names.insert(kind.name);
  }
  CHECK(names.size() == measure_kinds().size());
}

TEST_CASE("Crater: where nothing moves at the start there is no direction of impact, and that is told") {
  auto event = event_of({});
  for (auto& velocity : event.initial.velocity) velocity = Point::zero();
  CHECK_THROWS_WITH(take("crater_diameter", event), Catch::Contains("no body moves against the target"));
}

TEST_CASE("Extension: a projectile with a hole on its flight line has none, and that is told") {
  auto event = event_of({Space::plane_strain, {0.0, 0.0, 30e-3, false}, false, as_it_is, {}});
  for (auto& position : event.last.position)
    if (std::abs(position[1]) < 3e-3) position[1] += 10e-3;
  CHECK_THROWS_WITH(take("projectile_extension", event), Catch::Contains("a hole on its flight line"));
}

}  // namespace tektite::test
