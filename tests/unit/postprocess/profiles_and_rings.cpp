// Measures of a ring, and the error of a profile, on states made by hand.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <numbers>

#include "postprocess/measure/measure.hpp"
#include "support/fault.hpp"
#include "support/temporary_folder.hpp"
#include "unit/postprocess/synthetic.hpp"

using namespace tektite;

namespace {

/// A ring of 10 to 14 mm that has shrunk so that every circle keeps its area to the inner surface, and is drawn out to
/// an ellipse of this axis ratio.
std::vector<test::Placed> ring(double inner, double ratio) {
  std::vector<test::Placed> placed;
  for (int circle = 0; circle < 4; ++circle) {
    const double start = 10e-3 + (circle + 0.5) * test::spacing;
    const double r = std::sqrt(start * start - 100e-6 + inner * inner);
    const int count = 60 + 6 * circle;
    for (int k = 0; k < count; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / count;
      placed.push_back({"ring", {r * ratio * std::cos(angle), r * std::sin(angle), 0.0}, {0.0, 0.0, 0.0}});
    }
  }
  return placed;
}

const std::string ring_scene =
    "name = 'ring'\nspace = 'plane-strain'\n[body.ring]\nmaterial = 'aluminium'\n[measure.inner_radius]\nbody = "
    "'ring'\n[measure.outer_radius]\nbody = 'ring'\n[measure.symmetry_error]\nbody = 'ring'\n[measure.early]\ntype = "
    "'inner_radius'\nbody = 'ring'\ntime = 4e-5\n";

std::map<std::string, Measured> measured(const std::string& scene, const Declared& declared, const Event& event) {
  auto document = Document::parse(scene, "scene.toml");
  auto root = document.root();
  std::map<std::string, Measured> values;
  for (const auto& measure : read_measures(root, declared)) values[measure.name] = test::taken(measure, event);
  return values;
}

}  // namespace

TEST_CASE("Rings: the radii are those of the surfaces, at the end or at a time") {
  const test::TemporaryFolder folder;
  Event event;
  const auto save = [&](double inner, double time) {
    const auto snapshot = test::snapshot_of(Space::plane_strain, ring(inner, 1.0), time, ring_scene, test::as_it_is);
    event.snapshots.push_back(folder.file(fmt::format("{}.h5", event.snapshots.size())));
    event.times.push_back(time);
    write_snapshot(snapshot, event.snapshots.back());
    return make_whole(snapshot, {});
  };
  event.initial = save(10e-3, 0.0);
  save(8e-3, 3.9e-5);
  event.last = save(5e-3, 8e-5);
  const auto values = measured(ring_scene, {Space::plane_strain, {"ring"}, {}}, event);
  CHECK(values.at("inner_radius").value == Approx(5e-3).epsilon(1e-12));
  CHECK(values.at("outer_radius").value == Approx(std::sqrt(196e-6 - 75e-6)).epsilon(1e-12));
  CHECK(values.at("symmetry_error").value == Approx(0.0).margin(1e-12));
  CHECK(values.at("early").value == Approx(8e-3).epsilon(1e-12));
  CHECK(values.at("early").time == 3.9e-5);
  // A run that was stopped has no state of then.
  event.snapshots.pop_back();
  event.times.pop_back();
  event.last.time = 3.9e-5;
  CHECK_THROWS_WITH(measured(ring_scene, {Space::plane_strain, {"ring"}, {}}, event),
                    Catch::Contains("the run ends at 3.9e-05 s, before the 4e-05 s at which it is looked for"));
}

TEST_CASE("Rings: the symmetry error is the spread of the innermost particles' radii") {
  Event event;
  event.initial =
      make_whole(test::snapshot_of(Space::plane_strain, ring(10e-3, 1.0), 0.0, ring_scene, test::as_it_is), {});
  event.last = make_whole(
      test::snapshot_of(Space::plane_strain, ring(10e-3, 1.02), 1e-5, ring_scene, test::turned_by_30_degrees), {});
  const std::string scene = "[measure.symmetry_error]\nbody = 'ring'\n";
  const auto values = measured(scene, {Space::plane_strain, {"ring"}, {}}, event);
  CHECK(values.at("symmetry_error").value == Approx(0.02 / 1.01).epsilon(0.01));  // the mean radius of the ellipse
  // r = b (1 + 0.02 cos²θ) to the first order: it changes by 0.02 b sin 2θ Δθ from one of the 60 particles to the next.
  CHECK(values.at("symmetry_error").uncertainty == Approx(0.02 / 1.01 * 2.0 * std::numbers::pi / 60).epsilon(0.05));
}

TEST_CASE("Rings: a line has none, and a section through an axis neither") {
  for (const auto space : {Space::line, Space::axisymmetric}) {
    auto document = Document::parse("[measure.inner_radius]\nbody = 'bar'\n", "scene.toml");
    auto root = document.root();
    CHECK_THAT(test::fault_of([&] { read_measures(root, {space, {"bar"}, {}}); }), Catch::Contains("in the plane"));
  }
}

TEST_CASE("Profiles: the error is the mean difference over the range of the exact solution") {
  std::vector<test::Placed> placed;
  for (int k = 0; k < 10; ++k)
    placed.push_back({"bar", {(k + 0.5) * test::spacing, 0.0, 0.0}, {k < 6 ? 40.0 : 0.0, 0.0, 0.0}});
  Event event;
  event.last_snapshot = test::snapshot_of(Space::line, placed, 1e-6, "name = 'bar'\nspace = 'line'\n", test::as_it_is);
  event.last = make_whole(event.last_snapshot, {});
  const std::string scene = "[measure.error_l1]\nprofile = 'velocity'\nexact = [[0, 40], [4e-3, 20], [5e-3, 0]]\n";
  const auto values = measured(scene, {Space::line, {"bar"}, {}}, event);
  // One particle of ten is wrong by 20, one by 40, of a range of 40.
  CHECK(values.at("error_l1").value == Approx(0.1 * (20.0 + 40.0) / 40.0));
  // Moving both waves by half a spacing of ten changes 0.05 · (20 + 20) of 40.
  CHECK(values.at("error_l1").uncertainty == Approx(0.05));
}

TEST_CASE("Profiles: an exact solution without a range, out of order or in another unit is refused") {
  const auto read = [](const std::string& exact) {
    auto document = Document::parse("[measure.error_l1]\nprofile = 'stress'\nexact = " + exact + "\n", "scene.toml");
    auto root = document.root();
    return read_measures(root, {Space::line, {"bar"}, {}});
  };
  const auto fault = [&](const std::string& exact) { return test::fault_of([&] { read(exact); }); };
  CHECK(read("[['0 mm', '5 GPa'], ['4 mm', '0 GPa']]").size() == 1);
  CHECK_THAT(fault("[[0, 5], [4e-3, 5]]"), Catch::Contains("scene.toml:3") &&
                                               Catch::Contains("measure.error_l1.exact") &&
                                               Catch::Contains("all values are the same"));
  CHECK_THAT(fault("[[0, 5], [4e-3, 1], [3e-3, 0]]"),
             Catch::Contains("x = 0.004 m does not rise to the next, 0.003 m"));
  CHECK_THAT(fault("[[0, 5], [0, 1]]"), Catch::Contains("does not rise"));
  CHECK_THAT(fault("[[0, '5 m'], [1, 0]]"), Catch::Contains("this is a length") && Catch::Contains("pressure"));
}

TEST_CASE("Profiles: measures of Noh's problem are uncertain by what half a spacing changes") {
  // After 90.6 us the shock is at 30.2 mm; the two particles at the wall are hotter than they should be.
  std::vector<test::Placed> start, placed;
  for (int k = 0; k < 100; ++k) {
    const double x = (k + 0.5) * test::spacing;
    start.push_back({"gas", {x, 0.0, 0.0}, {-1000.0, 0.0, 0.0}});
    placed.push_back({"gas", {x, 0.0, 0.0}, {k < 30 ? 0.0 : -1000.0, 0.0, 0.0}});
  }
  const test::TemporaryFolder folder;
  Event event;
  const auto first = test::snapshot_of(Space::line, start, 0.0, "", test::as_it_is);
  event.snapshots = {folder.file("0.h5")};
  write_snapshot(first, event.snapshots.front());
  event.initial = make_whole(first, {});
  event.last_snapshot = test::snapshot_of(Space::line, placed, 90.6e-6, "", test::as_it_is);
  event.last_snapshot.particles.allocate(Field::specific_internal_energy);
  const auto energy = event.last_snapshot.particles.reals(Field::specific_internal_energy);
  for (std::size_t k = 0; k < 30; ++k) energy[k] = k == 0 ? 0.6e6 : k == 1 ? 0.55e6 : 0.5e6;
  event.last = make_whole(event.last_snapshot, {});
  const std::string keys = "body = 'gas'\nfrom = '10 mm'\nto = '60 mm'\n";
  const auto values = measured("[measure.wall_heating]\n" + keys + "[measure.error_l1_energy]\n" + keys,
                               {Space::line, {"gas"}, {}}, event);
  CHECK(values.at("wall_heating").value == Approx(1.2));
  CHECK(values.at("wall_heating").uncertainty == Approx(0.05));
  CHECK(values.at("error_l1_energy").value == Approx(0.0).margin(1e-6));
  CHECK(values.at("error_l1_energy").uncertainty == Approx(0.5e6 / 50));  // one of 50 particles, ahead of the shock
}

TEST_CASE("Profiles: a pulse has parted into two halves of half the speed") {
  // Width 4 mm about 20 mm, at rest in between; after 8 us at 1 km/s the halves are at 12 mm and 28 mm.
  const auto half_of = [](double x, double centre) {
    const double share = (x - centre) / 4e-3;
    return std::abs(share) < 0.5 ? 20.0 * std::pow(std::cos(std::numbers::pi * share), 4) : 0.0;
  };
  const std::string scene =
      "[measure.error_l1_pulse]\nbody = 'bar'\nspeed = 40\ncentre = 2e-2\nwidth = 4e-3\nwave_speed = 1000\n";
  for (const double factor : {1.0, 0.7}) {
    std::vector<test::Placed> start, placed;
    for (int k = 0; k < 40; ++k) {
      const double x = (k + 0.5) * test::spacing;
      start.push_back({"bar", {x, 0.0, 0.0}, {0.0, 0.0, 0.0}});
      // It has also been carried 3 mm along, which is nothing to the wave in the bar.
      placed.push_back({"bar", {x + 3e-3, 0.0, 0.0}, {factor * (half_of(x, 12e-3) + half_of(x, 28e-3)), 0.0, 0.0}});
    }
    Event event;
    const std::string text = "name = 'bar'\nspace = 'line'\n";
    event.initial = make_whole(test::snapshot_of(Space::line, start, 0.0, text, test::as_it_is), {});
    event.last_snapshot = test::snapshot_of(Space::line, placed, 8e-6, text, test::as_it_is);
    event.last = make_whole(event.last_snapshot, {});
    const auto error = measured(scene, {Space::line, {"bar"}, {}}, event).at("error_l1_pulse");
    CHECK(error.value == Approx(1.0 - factor).margin(1e-12));
    CHECK(error.uncertainty > 0.0);
  }
}
