// Debris, plug and lip on a perforated plate that is made by hand, whole and as a quarter, in several orientations.

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/kernel_type.hpp"
#include "unit/postprocess/plate.hpp"

namespace tektite::test {
namespace {

Measured take(const std::string& name, const Event& event) { return take_of(plate_scene(false), name, event); }

Point along_z(const Point& a) { return {-a[2], a[1], a[0]}; }
Point askew(const Point& a) {
  const auto b = turned_by_30_degrees(a);
  return {0.8 * b[0] - 0.6 * b[2], b[1], 0.6 * b[0] + 0.8 * b[2]};
}

/// The same plate in several orientations, held by its clamped edges and by its outermost tenth, and as a quarter.
std::vector<Plate> versions_of(const Plate& plate) {
  std::vector<Plate> versions(6, plate);
  versions[1].turn = along_z;
  versions[2].turn = askew;
  versions[3].turn = mirrored;
  versions[4].clamped = false;
  versions[5].quarter = true;
  return versions;
}

double length_of(const Measured& measured) {
  REQUIRE(measured.drawing);
  return norm(measured.drawing->to - measured.drawing->from);
}

/// Lets the run fail the outer part of the plug: it lay between 2 mm and the plug's radius.
Event with_failed_rim_of_plug(KernelType type) {
  const Plate plate;
  const auto start = particles_of(plate, true);
  auto last = plate_snapshot(plate, false);
  for (std::size_t i = 0; i < start.size(); ++i) {
    last.particles.integers(Field::kernel_type)[i] = static_cast<std::int64_t>(type);
    const double radius = std::hypot(start[i].position[1], start[i].position[2]);
    if (start[i].body == "plate" && radius > 2e-3 && radius < plate.plug_radius)
      last.particles.reals(Field::damage)[i] = 1.0;
  }
  return event_between(plate_snapshot(plate, true), std::move(last), {});
}

}  // namespace

TEST_CASE("Debris, plug and lip: each has its value in every orientation, whole and as a quarter") {
  for (const auto& plate : versions_of({})) {
    const auto event = event_of(plate);
    CHECK(take("debris_velocity", event).value == Approx(257.0).epsilon(1e-9));
    CHECK(take("plug_velocity", event).value == Approx(373.0).epsilon(1e-9));

    // The plug's lattice reaches to (3.5 mm, 1.5 mm) and its opposite; degrees miss a ten-thousandth at most.
    const auto width = take("plug_width", event);
    CHECK(width.value == Approx(2.0 * std::hypot(3.5e-3, 1.5e-3)).epsilon(1e-4));
    CHECK(length_of(width) == Approx(width.value).epsilon(1e-9));
    CHECK(width.uncertainty >= spacing);

    const auto diameter = take("impact_diameter", event);
    CHECK(diameter.value == Approx(diameter_of_lip(plate)).epsilon(1e-9));
    CHECK(length_of(diameter) == Approx(diameter.value).epsilon(1e-9));
    CHECK(diameter.uncertainty >= spacing);

    // The lip is as long as from the bend to the plug's edge, which the lattice makes rough by up to a spacing; its
    // foot is half a spacing above the centres of the exit face.
    const auto height = take("lip_height", event);
    const double longest = plate.bend_radius - plate.plug_radius + 0.5 * spacing;
    CHECK(height.value <= longest);
    CHECK(height.value >= longest - spacing);
    CHECK(length_of(height) == Approx(height.value).epsilon(1e-9));
    CHECK(height.uncertainty >= spacing);
  }
}

TEST_CASE("Plug and lip: a moving observer measures the same, and other velocities") {
  const auto event = event_of({});
  const auto seen = carried_along(event, {-700.0, 300.0, 90.0});
  for (const std::string name : {"plug_width", "impact_diameter", "lip_height"}) {
    INFO(name);
    CHECK(take(name, seen).value == Approx(take(name, event).value).epsilon(1e-9));
  }
  CHECK(take("debris_velocity", seen).value == Approx(257.0 - 700.0).epsilon(1e-9));
}

TEST_CASE("Debris: the uncertainty of its velocity holds how far its ends differ") {
  auto event = event_of(Plate{});
  CHECK(take("debris_velocity", event).uncertainty == Approx(0.0).margin(1e-9));
  for (std::size_t i = 0; i < event.last.count(); ++i)
    if (event.last.body[i] == 0) event.last.velocity[i][0] += 1e4 * (event.last.position[i][0] - 30e-3);
  // A sphere's coordinate has the deviation R/√5; the end layers are a spacing of its 12 mm. A lattice is no sphere.
  const double expected = 1e4 * 6e-3 / std::sqrt(5.0) * spacing / 12e-3;
  CHECK(take("debris_velocity", event).uncertainty == Approx(expected).epsilon(0.03));
}

TEST_CASE("Plug: where nothing of the plate flies ahead of the debris, that is told") {
  Plate plate;
  plate.crumbs = false;
  plate.plug_at = 10e-3;
  const auto event = event_of(plate);
  CHECK_THROWS_WITH(take("plug_width", event), Catch::Contains("no plug"));
  CHECK_THROWS_AS(take("plug_velocity", event), RunError);
  CHECK(take("impact_diameter", event).value == Approx(diameter_of_lip(plate)).epsilon(1e-9));
}

TEST_CASE("Plug: where only crumbs fly ahead, it is a crumb, which is as wide as a point is") {
  Plate plate;
  plate.plug_at = 10e-3;
  const auto event = event_of(plate);
  const auto width = take("plug_width", event);
  CHECK(width.value == 0.0);
  CHECK(width.uncertainty == Approx(spacing));
  CHECK(take("plug_velocity", event).value == Approx(450.0).epsilon(1e-9));
}

TEST_CASE("Plug: of crumbs of the same mass it is the foremost, whichever comes first in the list") {
  Plate plate;
  plate.plug_at = 10e-3;
  auto last = plate_snapshot(plate, false);
  double foremost = 0.0;
  const auto* places = last.particles.vectors<3>(Field::position);
  for (std::size_t i = 0; i < last.particles.count(); ++i) foremost = std::max(foremost, places[i][0]);
  for (std::size_t i = 0; i < last.particles.count(); ++i)
    if (places[i][0] > 0.09) last.particles.vectors<3>(Field::velocity)[i][0] = 1e3 * places[i][0];
  const auto event = event_between(plate_snapshot(plate, true), std::move(last), {});
  CHECK(take("plug_velocity", event).value == Approx(1e3 * foremost).epsilon(1e-9));
}

TEST_CASE("Plug: failed total-Lagrangian particles are no part of it, failed Eulerian ones are") {
  const auto full = 2.0 * std::hypot(3.5e-3, 1.5e-3);
  const auto core = 2.0 * std::hypot(1.5e-3, 0.5e-3);
  CHECK(take("plug_width", with_failed_rim_of_plug(KernelType::eulerian)).value == Approx(full).epsilon(1e-4));
  CHECK(take("plug_width", with_failed_rim_of_plug(KernelType::total_lagrangian)).value == Approx(core).epsilon(1e-4));
}

TEST_CASE("Lip: a hole without one has the diameter of the hole and no height") {
  Plate plate;
  plate.plug_radius = plate.bend_radius;
  const auto event = event_of(plate);
  const auto diameter = take("impact_diameter", event);
  // The innermost of each sector lies within a spacing behind the edge.
  CHECK(diameter.value > 2.0 * plate.plug_radius);
  CHECK(diameter.value < 2.0 * plate.plug_radius + 2.0 * spacing);
  CHECK(take("lip_height", event).value == Approx(0.0).margin(1e-9));
}

TEST_CASE("Lip: a plate that bulges without a hole has none, and that is told") {
  const Plate plate;
  auto last = plate_snapshot(plate, true);
  auto* position = last.particles.vectors<3>(Field::position);
  for (std::size_t i = last.particles.bodies()[1].range.begin; i < last.particles.count(); ++i) {
    const double radius = std::hypot(position[i][1], position[i][2]);
    position[i][0] += 5e-3 * std::exp(-std::pow(radius / 10e-3, 2));
  }
  const auto event = event_between(plate_snapshot(plate, true), std::move(last), {});
  CHECK_THROWS_WITH(take("impact_diameter", event), Catch::Contains("not perforated"));
  CHECK_THROWS_WITH(take("lip_height", event), Catch::Contains("not perforated"));
}

TEST_CASE("Lip: the height counts from the clamped edge, wherever the rest of the plate has gone") {
  Plate plate;
  const double at_rest = take("lip_height", event_of(plate)).value;
  const auto start = particles_of(plate, true);
  auto last = plate_snapshot(plate, false);
  for (std::size_t i = 0; i < start.size(); ++i)
    if (last.particles.integers(Field::clamped)[i] == 0 && start[i].body == "plate")
      last.particles.vectors<3>(Field::position)[i][0] += 0.6e-3;
  const auto event = event_between(plate_snapshot(plate, true), std::move(last), {});
  CHECK(take("lip_height", event).value == Approx(at_rest + 0.6e-3).epsilon(1e-9));
}

TEST_CASE("Lip: a rim that has gone, from a side or from the exit face, is told") {
  const Plate plate;
  auto one_side = plate_snapshot(plate, false);
  auto* position = one_side.particles.vectors<3>(Field::position);
  for (std::size_t i = 0; i < one_side.particles.count(); ++i) position[i][1] = std::abs(position[i][1]);
  CHECK_THROWS_WITH(take("lip_height", event_between(plate_snapshot(plate, true), std::move(one_side), {})),
                    Catch::Contains("does not surround the flight line"));

  auto front_alone = plate_snapshot(plate, false);
  const auto start = particles_of(plate, true);
  for (std::size_t i = 0; i < start.size(); ++i)
    if (start[i].position[0] > 1e-3) front_alone.particles.integers(Field::clamped)[i] = 0;
  CHECK_THROWS_WITH(take("lip_height", event_between(plate_snapshot(plate, true), std::move(front_alone), {})),
                    Catch::Contains("no particle on its exit face"));
}

}  // namespace tektite::test
