#include <catch2/catch.hpp>
#include <cmath>

#include "preprocess/velocity/velocity.hpp"
#include "support/fault.hpp"

using namespace tektite;
using namespace tektite::preprocess;

namespace {

VelocityPointer velocity_of(const std::string& value, Space space) {
  auto document = Document::parse(value.empty() ? "" : "velocity = " + value, "scene.toml");
  auto root = document.root();
  return read_velocity(root, space);
}

}  // namespace

TEST_CASE("Velocity: uniform as a list, at rest where left out") {
  CHECK(velocity_of("['3.1 km/s', 0]", Space::plane_strain)->at({{4, 5, 0}})[0] == 3100.0);
  CHECK(norm(velocity_of("", Space::solid)->at({{4, 5, 6}})) == 0.0);
}

TEST_CASE("Velocity: radial has one speed towards the centre, which rests") {
  const auto velocity = velocity_of("{ type = 'radial', speed = 2, centre = [1, 0] }", Space::plane_strain);
  const auto v = velocity->at({{1.0 + 3.0, 4.0, 0}});
  CHECK(v[0] == Approx(-1.2));
  CHECK(v[1] == Approx(-1.6));
  CHECK(norm(velocity->at({{1, 0, 0}})) == 0.0);
}

TEST_CASE("Velocity: radial-inverse carries the same area through every circle") {
  const auto velocity = velocity_of("{ type = 'radial-inverse', speed = 10, radius = 2 }", Space::plane_strain);
  for (const double r : {0.5, 2.0, 7.0}) CHECK(velocity->at({{0, r, 0}})[1] * r == Approx(-20.0));
}

TEST_CASE("Velocity: rotation is omega cross r, about z in the plane and about any axis in a solid") {
  const auto plane =
      velocity_of("{ type = 'rotation', rate = 3, centre = [1, 1] }", Space::plane_strain)->at({{2, 1, 0}});
  CHECK(plane[0] == Approx(0.0));
  CHECK(plane[1] == Approx(3.0));
  const auto solid = velocity_of("{ type = 'rotation', rate = 3, axis = [2, 0, 0] }", Space::solid)->at({{5, 1, 0}});
  CHECK(solid[2] == Approx(3.0));
  CHECK(solid[0] == Approx(0.0));
}

TEST_CASE("Velocity: a pulse is highest at its centre, a quarter of that a quarter of its width off, and ends") {
  const auto velocity = velocity_of("{ type = 'pulse', speed = 2, centre = 1, width = 0.4 }", Space::line);
  CHECK(velocity->at({{1.0, 0, 0}})[0] == Approx(2.0));
  CHECK(velocity->at({{1.1, 0, 0}})[0] == Approx(0.5));  // cos⁴(π/4) = 1/4
  CHECK(velocity->at({{0.9, 0, 0}})[0] == Approx(0.5));
  CHECK(velocity->at({{1.2, 0, 0}})[0] == Approx(0.0).margin(1e-30));  // cos(π/2) in doubles, to the fourth
  CHECK(velocity->at({{3.0, 0, 0}})[0] == 0.0);
}

TEST_CASE("Velocity: wrong ones are refused") {
  CHECK_THAT(test::fault_of([] { velocity_of("{ type = 'spin' }", Space::plane_strain); }),
             Catch::Contains("uniform, radial, radial-inverse, rotation, pulse"));
  CHECK_THAT(test::fault_of([] { velocity_of("['3 m', 0]", Space::plane_strain); }), Catch::Contains("speed"));
  CHECK_THAT(test::fault_of([] { velocity_of("[1, 2, 3]", Space::plane_strain); }),
             Catch::Contains("list of 2 values"));
  CHECK_THAT(test::fault_of([] { velocity_of("{ type = 'rotation', rate = 1 }", Space::line); }),
             Catch::Contains("line"));
  CHECK_THAT(test::fault_of([] { velocity_of("{ type = 'rotation', rate = 1 }", Space::axisymmetric); }),
             Catch::Contains("has no spin"));
}
