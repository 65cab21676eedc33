// Extents of a rod and areas that have failed, on states made by hand.
#include <catch2/catch.hpp>

#include "postprocess/measure/measure.hpp"
#include "unit/postprocess/synthetic.hpp"

namespace tektite::test {
namespace {

/// A rod of 20 mm by 8 mm at rest: particles on its surface, or in the middles of cells.
Event rod(double from_surface) {
  const auto rows = [&](double length) { return static_cast<int>(std::round(length / spacing - 2.0 * from_surface)); };
  std::vector<Placed> placed;
  for (int y = 0; y <= rows(20e-3); ++y)
    for (int x = 0; (x + from_surface) * spacing < 4.0001e-3; ++x)
      placed.push_back({"body", {(x + from_surface) * spacing, (y + from_surface) * spacing, 0.0}, Point::zero()});
  Event event;
  event.last_snapshot = snapshot_of(Space::axisymmetric, placed, 1.0, "", as_it_is);
  event.initial = event.last = make_whole(event.last_snapshot, {});
  return event;
}

Measured take(const std::string& kind, Space space, const Event& event) {
  auto document = Document::parse("[measure." + kind + "]\nbody = 'body'\n", "scene.toml");
  auto root = document.root();
  return read_measures(root, {space, {"body"}, {}}).front().measure(event);
}

}  // namespace

TEST_CASE("Rod: extents are exact with particles on the surface, and right to the uncertainty without") {
  const auto on_surface = rod(0.0), within = rod(0.5);
  constexpr double rounding = 1e-12;
  for (const auto& [kind, exact] : {std::pair{"final_length", 20e-3}, {"face_diameter", 8e-3}}) {
    INFO(kind);
    CHECK(take(kind, Space::axisymmetric, on_surface).value == Approx(exact).epsilon(rounding));
    const auto measured = take(kind, Space::axisymmetric, within);
    CHECK(std::abs(measured.value - exact) <= measured.uncertainty + rounding);
  }
}

TEST_CASE("Damaged area: what has failed of a sheet has its area, however thin it has become") {
  std::vector<Placed> placed;
  for (int k = 0; k < 10; ++k) placed.push_back({"body", {k * spacing, 0.0, 0.0}, Point::zero()});
  Event event;
  event.last_snapshot = snapshot_of(Space::plane_stress, placed, 1.0, "", as_it_is);
  auto& particles = event.last_snapshot.particles;
  particles.allocate(Field::damage);
  particles.allocate(Field::thickness);
  std::ranges::fill(particles.reals(Field::thickness), 0.8);
  for (auto& density : particles.reals(Field::density)) density /= 0.8;
  for (int k = 0; k < 4; ++k) particles.reals(Field::damage)[static_cast<std::size_t>(k)] = 1.0;
  event.initial = event.last = make_whole(event.last_snapshot, {});
  CHECK(take("damaged_area", Space::plane_stress, event).value == Approx(4.0 * spacing * spacing).epsilon(1e-12));
}

}  // namespace tektite::test
