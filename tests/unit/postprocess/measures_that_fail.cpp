// What cannot be measured is told with its reason, on states made by hand.
#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "postprocess/measure/measure.hpp"
#include "support/temporary_folder.hpp"
#include "unit/postprocess/synthetic.hpp"

namespace tektite::test {
namespace {

using Catch::Contains;

/// Ten particles side by side along x, whose radii have been multiplied by `stretch` and whose velocity is `speed`.
Event row(Space space, double stretch, double speed) {
  std::vector<Placed> start, end;
  for (int k = 0; k < 10; ++k) {
    const double x = (k + 0.5) * spacing;
    start.push_back({"body", {x, 0.0, 0.0}, {-1.0, 0.0, 0.0}});
    end.push_back({"body", {stretch * x, 0.0, 0.0}, {speed, 0.0, 0.0}});
  }
  Event event;
  event.initial = make_whole(snapshot_of(space, start, 0.0, "", as_it_is), {});
  event.last_snapshot = snapshot_of(space, end, 1.0, "", as_it_is);
  event.last = make_whole(event.last_snapshot, {});
  return event;
}

/// Takes the only measure of a scene.
void take(const std::string& scene, Space space, const Event& event) {
  auto document = Document::parse(scene, "scene.toml");
  auto root = document.root();
  for (const auto& measure : read_measures(root, {space, {"body"}, {}})) taken(measure, event);
}

}  // namespace

TEST_CASE("Measures that fail: a field that the run does not have") {
  const auto event = row(Space::plane_strain, 1.0, 0.0);
  CHECK_THROWS_WITH(take("[measure.max_temperature]\nbody = 'body'\n", Space::plane_strain, event),
                    Contains("the snapshot has no temperature"));
  CHECK_THROWS_WITH(take("[measure.damaged_area]\nbody = 'body'\n", Space::plane_strain, event),
                    Contains("the snapshot has no damage"));
}

TEST_CASE("Measures that fail: the initial state, which has no pressure, stress or energy") {
  auto event = row(Space::line, 1.0, -1.0);
  for (const auto field : {Field::pressure, Field::plastic_strain, Field::sound_speed})
    event.last_snapshot.particles.release(field);
  const TemporaryFolder folder;
  event.snapshots = {folder.file("000000.h5")};
  write_snapshot(event.last_snapshot, event.snapshots.front());
  const std::string gas = "body = 'body'\nfrom = 0\nto = 1\n", exact = "exact = [[0, 1], [1, 2]]\n";
  CHECK_THROWS_WITH(take("[measure.error_l1_pressure]\n" + gas, Space::line, event), Contains("no pressure"));
  CHECK_THROWS_WITH(take("[measure.wall_heating]\n" + gas, Space::line, event),
                    Contains("no specific_internal_energy"));
  CHECK_THROWS_WITH(take("[measure.error_l1]\nprofile = 'stress'\n" + exact, Space::line, event),
                    Contains("no pressure"));
  event.last_snapshot.particles.allocate(Field::pressure);
  CHECK_THROWS_WITH(take("[measure.error_l1]\nprofile = 'stress'\n" + exact, Space::line, event),
                    Contains("no deviatoric_stress"));
  CHECK_THROWS_WITH(take("[measure.interface_jump]\nbody = 'body'\n", Space::line, event), Contains("no kernel_type"));
}

TEST_CASE("Measures that fail: the temperature of a body that does not heat, beside one that does") {
  auto event = row(Space::plane_strain, 1.0, 0.0);
  event.last_snapshot.particles.allocate(Field::temperature);
  CHECK_THROWS_WITH(take("[measure.max_temperature]\nbody = 'body'\n", Space::plane_strain, event),
                    Contains("the strength of body does not heat"));
}

TEST_CASE("Measures that fail: a ring that has closed") {
  CHECK_THROWS_WITH(
      take("[measure.inner_radius]\nbody = 'body'\n", Space::plane_strain, row(Space::plane_strain, 0.0, 0.0)),
      Contains("the ring has closed"));
}

TEST_CASE("Measures that fail: a rod whose tail is deformed, and one in a plane") {
  const std::string flying = "[measure.undeformed_length]\nbody = 'body'\n", scene = flying + "axis = [0, -1]\n";
  CHECK_THROWS_WITH(take(scene, Space::axisymmetric, row(Space::axisymmetric, 1.5, 0.0)),
                    Contains("the tail itself is deformed"));
  CHECK_THROWS_WITH(take(flying, Space::axisymmetric, row(Space::axisymmetric, 1.5, 0.0)),
                    Contains("a rod flies along y"));
  CHECK_THROWS_WITH(take(scene, Space::plane_strain, row(Space::plane_strain, 1.5, 0.0)),
                    Contains("in an axisymmetric space or a solid, not in plane-strain"));
}

TEST_CASE("Measures that fail: a pulse that has left the body") {
  CHECK_THROWS_WITH(
      take("[measure.error_l1_pulse]\nbody = 'body'\nspeed = 40\ncentre = 5e-3\nwidth = 4e-3\nwave_speed = 1000\n",
           Space::line, row(Space::line, 1.0, 0.0)),
      Contains("the pulse has left the body"));
}

TEST_CASE("Measures that fail: a gas without a shock, one at rest, and radii without particles between them") {
  const TemporaryFolder folder;
  auto event = row(Space::line, 1.0, -1.0);
  event.snapshots = {folder.file("000000.h5")};
  write_snapshot(event.last_snapshot, event.snapshots.front());
  CHECK_THROWS_WITH(take("[measure.shock_position]\nbody = 'body'\n", Space::line, event),
                    Contains("no shock runs through the gas"));
  CHECK_THROWS_WITH(take("[measure.error_l1_density]\nbody = 'body'\nfrom = 1\nto = 2\n", Space::line, event),
                    Contains("no particle lies between the radii"));
  event.last_snapshot.particles.allocate(Field::specific_internal_energy);
  CHECK_THROWS_WITH(take("[measure.wall_heating]\nbody = 'body'\nfrom = 0\nto = 1\n", Space::line, event),
                    Contains("no particle lies within the radius from"));
  for (auto& velocity : event.initial.velocity) velocity = Point::zero();
  CHECK_THROWS_WITH(take("[measure.shock_position]\nbody = 'body'\n", Space::line, event),
                    Contains("the gas does not move at the start"));
}

}  // namespace tektite::test
