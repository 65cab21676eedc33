// Extents of a rod and areas that have failed, on states made by hand.
#include <catch2/catch.hpp>

#include "postprocess/measure/measure.hpp"
#include "unit/postprocess/synthetic.hpp"

namespace tektite::test {
namespace {

/// A rod of 20 mm by 8 mm that flies downwards: particles on its surface, or in the middles of cells. A solid one is
/// turned, and stands off the origin.
Event rod(Space space, double from_surface, const Turn& turn) {
  const auto rows = [&](double length) { return static_cast<int>(std::round(length / spacing - 2.0 * from_surface)); };
  const auto along = [&](int k) { return (k + from_surface) * spacing; };
  const Point off = space == Space::solid ? Point{30e-3, 0.0, -50e-3} : Point::zero();
  std::vector<Placed> placed;
  for (int y = 0; y <= rows(20e-3); ++y)
    for (int x = 0; along(x) < 4.0001e-3; ++x) {
      const std::vector<Point> around{{1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}};
      for (std::size_t k = 0; k < (space == Space::solid ? around.size() : 1); ++k)
        placed.push_back({"body", off + along(x) * around[k] + Point{0.0, along(y), 0.0}, {0.0, -100.0, 0.0}});
    }
  Event event;
  event.last_snapshot = snapshot_of(space, placed, 1.0, "", turn);
  event.initial = event.last = make_whole(event.last_snapshot, {});
  return event;
}

Measured take(const std::string& kind, Space space, const Event& event) {
  auto document = Document::parse("[measure." + kind + "]\nbody = 'body'\n", "scene.toml");
  auto root = document.root();
  return taken(read_measures(root, {space, {"body"}, {}}).front(), event);
}

}  // namespace

TEST_CASE("Rod: extents are exact with particles on the surface, and right to the uncertainty without") {
  constexpr double rounding = 1e-12;
  const auto check = [&](Space space, const Turn& turn) {
    const auto on_surface = rod(space, 0.0, turn), within = rod(space, 0.5, turn);
    for (const auto& [kind, exact] : {std::pair{"final_length", 20e-3}, {"face_diameter", 8e-3}}) {
      INFO(kind);
      const auto measured = take(kind, space, on_surface);
      CHECK(measured.value == Approx(exact).epsilon(rounding));
      REQUIRE(measured.drawing);
      CHECK(norm(measured.drawing->to - measured.drawing->from) == Approx(exact).epsilon(rounding));
      const auto coarse = take(kind, space, within);
      CHECK(std::abs(coarse.value - exact) <= coarse.uncertainty + rounding);
    }
  };
  check(Space::axisymmetric, as_it_is);
  // Whichever way it flies.
  for (const auto& turn :
       {Turn(as_it_is), Turn(turned_by_90_degrees), Turn(turned_by_30_degrees), Turn([](const Point& a) {
          return Point{a[2], a[0], -a[1]};
        })})
    check(Space::solid, turn);
}

TEST_CASE("Spall velocity: of a face that moves as one it is uncertain by what the layer behind differs") {
  std::vector<Placed> placed{{"shot", {-3.0 * spacing, 0.0, 0.0}, {100.0, 0.0, 0.0}}};
  for (int x = 0; x < 10; ++x)
    for (int y = 0; y < 10; ++y)
      placed.push_back({"body", {x * spacing, y * spacing, 0.0}, {x == 9 ? 30.0 : 25.0, 0.0, 0.0}});
  Event event;
  event.last_snapshot = snapshot_of(Space::plane_strain, placed, 1.0, "", as_it_is);
  event.initial = event.last = make_whole(event.last_snapshot, {});
  auto document = Document::parse("[measure.spall_velocity]\nbody = 'body'\nprojectile = 'shot'\n", "scene.toml");
  auto root = document.root();
  const auto measured = taken(read_measures(root, {Space::plane_strain, {"shot", "body"}, {}}).front(), event);
  CHECK(measured.value == Approx(30.0).epsilon(1e-12));
  CHECK(measured.uncertainty == Approx(5.0).epsilon(1e-12));
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
