// How near neighbours come, how far pressure ranges, and what it does where kernel types meet: on a square lattice.

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "support/temporary_folder.hpp"
#include "unit/postprocess/plate.hpp"

namespace tektite::test {
namespace {

const std::string scene =
    "name = \"square\"\nspace = \"plane-strain\"\n[body.block]\nmaterial = \"a\"\n"
    "[measure.min_neighbour_distance]\nbody = \"block\"\n[measure.clumping_time]\nbody = \"block\"\n"
    "[measure.interface_jump]\nbody = \"block\"\n[measure.max_pressure]\nbody = \"block\"\n"
    "[measure.min_pressure]\nbody = \"block\"\n";

constexpr std::size_t side = 20;

/// A lattice of 20 x 20 whose right half is Eulerian; a particle in the middle is moved so that `nearest` spacings are
/// left to its neighbour. Pressure falls by 1 MPa a spacing along x, and by `jump` more at the interface.
Snapshot square(double nearest, double jump, double time) {
  std::vector<Placed> placed;
  for (std::size_t x = 0; x < side; ++x)
    for (std::size_t y = 0; y < side; ++y)
      placed.push_back({"block", {spacing * static_cast<double>(x), spacing * static_cast<double>(y), 0.0}, {1, 0, 0}});
  placed[side * 10 + 10].position[1] += (1.0 - nearest) * spacing;
  auto snapshot = snapshot_of(Space::plane_strain, placed, time, scene, as_it_is);
  snapshot.particles.allocate(Field::kernel_type);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const bool right = i / side >= side / 2;
    snapshot.particles.integers(Field::kernel_type)[i] = right ? 1 : 0;
    snapshot.particles.reals(Field::pressure)[i] = -1e6 * static_cast<double>(i / side) - (right ? jump : 0.0);
  }
  return snapshot;
}

Event event_of_square(double nearest, double jump) {
  return event_between(square(1.0, jump, 0.0), square(nearest, jump, 3e-6), {});
}

}  // namespace

TEST_CASE("Clumping: the smallest distance between neighbours is told in spacings") {
  CHECK(take_of(scene, "min_neighbour_distance", event_of_square(1.0, 0.0)).value == Approx(1.0).epsilon(1e-9));
  const auto measured = take_of(scene, "min_neighbour_distance", event_of_square(0.4, 0.0));
  CHECK(measured.value == Approx(0.4).epsilon(1e-9));
  // Within a smoothing length lie both of the pair at 0.4 and, at a spacing from their own nearest, four others.
  CHECK(measured.uncertainty > 0.0);
  CHECK(measured.uncertainty < 0.6);
}

TEST_CASE("Clumping: how uncertain the smallest distance is does not depend on which of the pair comes first") {
  const auto upwards = event_of_square(0.4, 0.0);
  auto turned = upwards;
  for (auto* whole : {&turned.initial, &turned.last}) std::reverse(whole->position.begin(), whole->position.end());
  CHECK(take_of(scene, "min_neighbour_distance", turned).uncertainty ==
        Approx(take_of(scene, "min_neighbour_distance", upwards).uncertainty).epsilon(1e-9));
}

TEST_CASE("Clumping: a particle on symmetry planes does not clump with its own image, one beside them does") {
  const TemporaryFolder folder;
  const std::vector<SymmetryPlane> planes{{0, 0.0, 1.0}, {1, 0.0, 1.0}};
  auto event = event_between(square(1.0, 0.0, 0.0), square(1.0, 0.0, 3e-6), planes);  // its first rows lie on both
  event.snapshots = {folder.file("0.h5"), folder.file("1.h5")};
  for (const auto& path : event.snapshots) write_snapshot(event.last_snapshot, path);
  CHECK(take_of(scene, "min_neighbour_distance", event).value == Approx(1.0).epsilon(1e-9));
  CHECK_THROWS_WITH(take_of(scene, "clumping_time", event), Catch::Contains("nearer than 0.5"));

  auto beside = event.last_snapshot;
  beside.particles.vectors<2>(Field::position)[side * 10][1] = 0.2 * spacing;
  CHECK(take_of(scene, "min_neighbour_distance", event_between(event.last_snapshot, beside, planes)).value ==
        Approx(0.4).epsilon(1e-9));
}

TEST_CASE("Clumping: its time is that of the first snapshot in which two particles are nearer than half a spacing") {
  const TemporaryFolder folder;
  auto event = event_of_square(0.3, 0.0);
  double time = 0.0;
  for (const double nearest : {1.0, 0.6, 0.45, 0.3}) {
    event.snapshots.push_back(folder.file(std::to_string(event.snapshots.size()) + ".h5"));
    write_snapshot(square(nearest, 0.0, time), event.snapshots.back());
    time += 1e-6;
  }
  const auto measured = take_of(scene, "clumping_time", event);
  CHECK(measured.value == Approx(2e-6));
  CHECK(measured.uncertainty == Approx(1e-6));
  event.snapshots.resize(2);
  CHECK_THROWS_WITH(take_of(scene, "clumping_time", event), Catch::Contains("nearer than 0.5"));
}

TEST_CASE("Pressure range: largest and least of the body, with sign") {
  const auto event = event_of_square(1.0, 0.0);
  CHECK(take_of(scene, "max_pressure", event).value == Approx(0.0).margin(1e-3));
  CHECK(take_of(scene, "min_pressure", event).value == Approx(-19e6));
  // Within h = 1.4 spacings of an edge particle lie one more on the row that differs by 1 MPa and at most three alike.
  CHECK(take_of(scene, "min_pressure", event).uncertainty >= 0.2e6);
  CHECK(take_of(scene, "min_pressure", event).uncertainty <= 0.5e6);
}

TEST_CASE("Interface: a gradient that runs through it gives 1, a jump stands out of it") {
  CHECK(take_of(scene, "interface_jump", event_of_square(1.0, 0.0)).value == Approx(1.0).epsilon(1e-9));
  CHECK(take_of(scene, "interface_jump", event_of_square(1.0, 2e6)).value == Approx(3.0).epsilon(1e-9));
}

TEST_CASE("Interface: without two kernel types there is none, and that is told") {
  auto event = event_of_square(1.0, 0.0);
  for (auto& type : event.last_snapshot.particles.integers(Field::kernel_type)) type = 1;
  CHECK_THROWS_WITH(take_of(scene, "interface_jump", event), Catch::Contains("no interface"));
  auto even = event_of_square(1.0, 0.0);
  for (auto& pressure : even.last_snapshot.particles.reals(Field::pressure)) pressure = 1e6;
  CHECK_THROWS_WITH(take_of(scene, "interface_jump", even), Catch::Contains("the pressure is uniform"));
  event.last_snapshot.particles.release(Field::kernel_type);
  CHECK_THROWS_WITH(take_of(scene, "interface_jump", event), Catch::Contains("no kernel_type"));
}

}  // namespace tektite::test
