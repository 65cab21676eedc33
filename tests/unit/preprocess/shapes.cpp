#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "preprocess/symmetry.hpp"
#include "scene_text.hpp"
#include "support/fault.hpp"

using namespace tektite;
using namespace tektite::preprocess;
using namespace tektite::test;

namespace {

struct Example {
  std::string table;
  int dimensions;
  double measure;
};

const std::string washer =
    "{ type = 'difference', parts = [{ type = 'disc', radius = 1.0 }, { type = 'disc', radius = 0.4 }] }";
const std::string turned =
    ", rotate = { angle = '33 deg', axis = [1, 2, -1], about = [0.3, 0, 1] }, translate = [1, 2, 3]";

double ogive_volume() {  // R = 0.5, L = 1.2, shank 0.7, by Simpson's rule
  const double rho = (0.25 + 1.44) / 1.0, c = rho - 0.5;
  constexpr int n = 20000;
  double sum = 0.0;
  for (int k = 0; k <= n; ++k) {
    const double u = 1.2 * k / n, y = std::sqrt(rho * rho - u * u) - c;
    sum += (k == 0 || k == n ? 1.0 : (k % 2 ? 4.0 : 2.0)) * y * y;
  }
  return M_PI * (sum * 1.2 / n / 3.0 + 0.25 * 0.7);
}

std::vector<Example> examples() {
  const std::string l_profile = "points = [[0, 0], [1, 0], [1, 0.3], [0.4, 0.3], [0.4, 0.8], [0, 0.8]]";
  return {
      {"{ type = 'segment', lower = -0.5, upper = 1.5 }", 1, 2.0},
      {"{ type = 'rectangle', lower = [0, 1], upper = [2, 1.5] }", 2, 1.0},
      {"{ type = 'rectangle', lower = [0, 1], upper = [2, 1.5], rotate = { angle = '30 deg' }, translate = [1, 0] }", 2,
       1.0},
      {"{ type = 'disc', centre = [1, 2], radius = 0.5 }", 2, M_PI / 4},
      {"{ type = 'ring', inner_radius = 1, outer_radius = 2 }", 2, 3 * M_PI},
      {"{ type = 'polygon', " + l_profile + " }", 2, 0.5},
      {washer, 2, M_PI * 0.84},
      {"{ type = 'union', parts = [{ type = 'rectangle', lower = [-1, -1], upper = [0, 1] }, { type = 'disc', radius = "
       "1 }] }",
       2, 2 + M_PI / 2},
      {"{ type = 'intersection', parts = [{ type = 'disc', radius = 1 }, { type = 'disc', centre = [1, 0], radius = 1 "
       "}] }",
       2, 2 * M_PI / 3 - std::sqrt(3.0) / 2},
      {"{ type = 'box', lower = [0, 0, 0], upper = [1, 2, 0.5]" + turned + " }", 3, 1.0},
      {"{ type = 'sphere', radius = 1, inner_radius = 0.5" + turned + " }", 3, 4.0 / 3.0 * M_PI * 0.875},
      {"{ type = 'cylinder', base = [1, 0, 0], axis = [1, 1, 0], length = 2, radius = 0.5, inner_radius = 0.2 }", 3,
       M_PI * 0.21 * 2},
      {"{ type = 'ogive', tip = [0, 0, 1], axis = [0, 0, -1], radius = 0.5, nose_length = 1.2, shank_length = 0.7 }", 3,
       ogive_volume()},
      {"{ type = 'revolved', " + l_profile + ", axis = [0, 1, 0] }", 3, M_PI * (0.4 * 0.64 + 0.6 * 0.09)},
      {"{ type = 'extruded', " + l_profile + ", axis = 'x', lower = -1, upper = 2 }", 3, 1.5},
      {"{ type = 'difference', parts = [{ type = 'box', lower = [0, 0, 0], upper = [1, 1, 1] }, "
       "{ type = 'box', lower = [0.5, 0.5, 0.5], upper = [2, 2, 2] }] }",
       3, 0.875},
      {"{ type = 'union', parts = [{ type = 'box', lower = [0, 0, 0], upper = [1, 1, 1] }, "
       "{ type = 'box', lower = [1, 0, 0], upper = [2, 1, 1] }] }",
       3, 2.0},
  };
}

}  // namespace

TEST_CASE("Shapes: the measure is the formula's, and random points inside agree with it") {
  const auto example = GENERATE(from_range(examples()));
  INFO(example.table);
  const auto shape = shape_of(example.table, example.dimensions);
  CHECK(shape->measure() == Approx(example.measure).epsilon(1e-9));  // Simpson's rule for the ogive has 1e-12
  const auto box = shape->bounds();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double volume = 1.0;
  for (int k = 0; k < example.dimensions; ++k) volume *= box.extent(k);
  constexpr int samples = 40000;
  int hits = 0;
  for (int n = 0; n < samples; ++n) {
    Point p{};
    for (int k = 0; k < example.dimensions; ++k) p[k] = box.lower[k] + uniform(random) * box.extent(k);
    hits += shape->inside(p, 0.0);
  }
  const double share = example.measure / volume;
  const double deviation = std::sqrt(share * std::max(1.0 - share, 0.0) / samples);
  CHECK(std::abs(static_cast<double>(hits) / samples - share) <= 5.0 * deviation + 1e-12);
}

TEST_CASE("Shapes: what a section sweeps about the axis is exact") {
  const std::vector<SymmetryPlane> axis{{0, 0.0, 1.0}};
  const auto swept = [&](const std::string& shape, const std::vector<SymmetryPlane>& planes) {
    return kept_measure(*shape_of(shape, 2), planes, Space::axisymmetric);
  };
  CHECK(swept("{ type = 'rectangle', lower = [0, 1], upper = [2, 4] }", axis) == Approx(12 * M_PI).epsilon(1e-12));
  CHECK(swept("{ type = 'disc', radius = 1.0, centre = [0, 3] }", axis) == Approx(4 * M_PI / 3).epsilon(1e-12));
  CHECK(swept("{ type = 'disc', radius = 1.0, centre = [3, 0] }", axis) == Approx(6 * M_PI * M_PI).epsilon(1e-12));
  CHECK(swept("{ type = 'ring', inner_radius = 1.0, outer_radius = 2.0, centre = [3, -1] }", axis) ==
        Approx(18 * M_PI * M_PI).epsilon(1e-12));
  CHECK(swept("{ type = 'polygon', points = [[0, 0], [3, 0], [0, 2]] }", axis) == Approx(6 * M_PI).epsilon(1e-12));
  const std::vector<SymmetryPlane> half{{0, 0.0, 1.0}, {1, 0.5, 1.0}};
  CHECK(swept("{ type = 'disc', radius = 1.0 }", half) == Approx(M_PI * 0.25 * 2.5 / 3.0).epsilon(1e-12));
  const auto segment = shape_of("{ type = 'segment', lower = 1.0, upper = 3.0 }", 1);
  CHECK(kept_measure(*segment, axis, Space::cylindrical) == Approx(8 * M_PI).epsilon(1e-12));
  CHECK(kept_measure(*segment, axis, Space::spherical) == Approx(104 * M_PI / 3).epsilon(1e-12));
}

TEST_CASE("Shapes: symmetry planes cut off the share that they should") {
  const std::vector<SymmetryPlane> quarter{{0, 0.0, 1.0}, {1, 0.0, -1.0}};
  const auto disc = shape_of("{ type = 'disc', radius = 1.0 }", 2);
  CHECK(kept_measure(*disc, quarter, Space::plane_strain) == Approx(M_PI / 4).epsilon(1e-12));
  const std::vector<SymmetryPlane> off_centre{{0, 0.5, 1.0}};
  CHECK(kept_measure(*disc, off_centre, Space::plane_strain) == Approx(M_PI / 3 - std::sqrt(3.0) / 4).epsilon(1e-12));
  const auto box = shape_of("{ type = 'box', lower = [-1, -1, 0], upper = [2, 1, 1] }", 3);
  CHECK(kept_measure(*box, quarter, Space::solid) == Approx(2.0).epsilon(1e-12));
  const auto ball = shape_of("{ type = 'sphere', radius = 1.0 }", 3);
  CHECK(kept_measure(*ball, quarter, Space::solid) == Approx(M_PI / 3).epsilon(1e-12));
  // A cap of height 1/2: π h² (3 − h)/3. The triangles' share of 1e-4 of the whole is what surface.hpp promises.
  const double cap = M_PI * 0.25 * 2.5 / 3.0;
  for (const int axis : {0, 1}) {
    const std::vector<SymmetryPlane> cut{{axis, 0.5, 1.0}};
    CHECK(std::abs(kept_measure(*ball, cut, Space::solid) - cap) < 1e-4 * ball->measure());
  }
  const auto segment = shape_of("{ type = 'segment', lower = -1.0, upper = 3.0 }", 1);
  CHECK(kept_measure(*segment, std::vector<SymmetryPlane>{{0, 0.0, -1.0}}, Space::line) == 1.0);
}

TEST_CASE("Shapes: a ball cut out of a box leaves its volume to the share that triangles cost") {
  const auto shape = shape_of(
      "{ type = 'difference', parts = [{ type = 'box', lower = [-2, -2, -2], upper = [0, 2, 2] }, "
      "{ type = 'sphere', radius = 1.0 }] }",
      3);
  CHECK(std::abs(shape->measure() - (32.0 - 2.0 / 3.0 * M_PI)) < 1e-4 * 4.0 / 3.0 * M_PI);
}

TEST_CASE("Shapes: booleans of solids that share corners, edges and faces have their volume") {
  const auto cylinder = [](const std::string& base, const std::string& axis) {
    return "{ type = 'cylinder', base = " + base + ", axis = " + axis + ", length = 2, radius = 1 }";
  };
  const auto x = cylinder("[-1, 0, 0]", "[1, 0, 0]"), y = cylinder("[0, -1, 0]", "[0, 1, 0]"),
             z = cylinder("[0, 0, -1]", "[0, 0, 1]");
  const auto boolean = [](const std::string& type, const std::string& parts) {
    return shape_of("{ type = '" + type + "', parts = [" + parts + "] }", 3)->measure();
  };
  // Steinmetz: 16/3 for two cylinders, 8 (2 - √2) for three; the share that triangles cost as in surface.hpp.
  const double steinmetz = 8.0 * (2.0 - std::sqrt(2.0)), tolerance = 1e-4 * 2.0 * M_PI;
  CHECK(std::abs(boolean("intersection", x + "," + y) - 16.0 / 3.0) < tolerance);
  CHECK(std::abs(boolean("intersection", x + "," + y + "," + z) - steinmetz) < 2.0 * tolerance);
  CHECK(std::abs(boolean("union", x + "," + y + "," + z) - (6.0 * M_PI - 16.0 + steinmetz)) < 3.0 * tolerance);
  const std::string half = "{ type = 'box', lower = [-2, -2, -2], upper = [2, 0, 2] }",
                    other_half = "{ type = 'box', lower = [-2, -2, -2], upper = [2, 2, 0] }";
  CHECK(boolean("difference", "{ type = 'sphere', radius = 1 }," + half + "," + other_half) == Approx(M_PI / 3));
}

TEST_CASE("Shapes: edges belong to a shape within the tolerance, and to what is left of it when another is cut out") {
  const auto disc = shape_of("{ type = 'disc', radius = 1.0 }", 2);
  CHECK(disc->inside({{1.0 + 0.5e-9, 0, 0}}, 1e-9));
  CHECK_FALSE(disc->inside({{1.0 + 2e-9, 0, 0}}, 1e-9));
  CHECK_FALSE(disc->inside({{1.0, 0, 0}}, -1e-9));
  const auto hole = shape_of(washer, 2);
  CHECK(hole->inside({{0.4, 0, 0}}, 1e-9));
  CHECK_FALSE(hole->inside({{0.4 - 2e-9, 0, 0}}, 1e-9));
}

TEST_CASE(
    "Shapes: asking a solid for its region, or what lies in the plane for its surface, is an error of the program") {
  CHECK_THROWS_WITH(shape_of("{ type = 'box', lower = [0, 0, 0], upper = [1, 1, 1] }", 3)->region({}),
                    "this shape is no region of the plane");
  CHECK_THROWS_WITH(shape_of("{ type = 'rectangle', lower = [0, 0], upper = [1, 1] }", 2)->surface({}),
                    "this shape is no solid");
}

TEST_CASE("Shapes: wrong ones are refused with the reason and what is allowed") {
  CHECK_THAT(fault_of([] { shape_of("{ type = 'dics', radius = 1 }", 2); }),
             Catch::Contains("rectangle, disc, ring, polygon, union, difference, intersection"));
  CHECK_THAT(fault_of([] { shape_of("{ type = 'disc', radius = 1 }", 3); }), Catch::Contains("box, sphere, cylinder"));
  CHECK_THAT(fault_of([] { shape_of("{ type = 'disc', radius = 1, width = 2 }", 2); }), Catch::Contains("unknown key"));
  CHECK_THAT(fault_of([] { shape_of("{ type = 'disc', radius = -1 }", 2); }), Catch::Contains("out of range"));
  CHECK_THAT(fault_of([] { shape_of("{ type = 'ring', inner_radius = 2, outer_radius = 1 }", 2); }),
             Catch::Contains("larger than inner_radius"));
  CHECK_THAT(fault_of([] { shape_of("{ type = 'rectangle', lower = [0, 0], upper = [1, 0] }", 2); }),
             Catch::Contains("larger than lower"));
  CHECK_THAT(fault_of([] { shape_of("{ type = 'polygon', points = [[0, 0], [1, 1], [1, 0], [0, 1]] }", 2); }),
             Catch::Contains("crosses or touches itself"));
  CHECK_THAT(fault_of([] { shape_of("{ type = 'polygon', points = [[0, 0], [1, 1]] }", 2); }),
             Catch::Contains("at least 3 points"));
  CHECK_THAT(fault_of([] { shape_of("{ type = 'ogive', radius = 2, nose_length = 1 }", 3); }),
             Catch::Contains("as long as its radius"));
  CHECK_THAT(fault_of([] { shape_of("{ type = 'revolved', points = [[0, -1], [1, 0], [0, 1]] }", 3); }),
             Catch::Contains("radial coordinate is negative"));
  CHECK_THAT(fault_of([] { shape_of("{ type = 'union', parts = [{ type = 'disc', radius = 1 }] }", 2); }),
             Catch::Contains("at least two parts"));
  CHECK_THAT(fault_of([] {
               shape_of(
                   "{ type = 'intersection', parts = [{ type = 'disc', radius = 1 }, "
                   "{ type = 'disc', centre = [3, 0], radius = 1 }] }",
                   2);
             }),
             Catch::Contains("nothing is left"));
}
