#include <omp.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "scene_text.hpp"
#include "support/fault.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

const std::string square =
    "[body.a]\nmaterial = 'unit'\nshape = { type = 'rectangle', lower = [0, 0], upper = [1, 1] }\n";

std::string disc_at(double x, const std::string& material) {
  return "[body.b]\nmaterial = '" + material + "'\nshape = { type = 'disc', centre = [" + std::to_string(x) +
         ", 0.5], radius = 0.5 }\n";
}

double sum(std::span<const double> values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

TEST_CASE("Particles: bodies in the order of the scene, with ids, density and smoothing length") {
  const auto result = result_of("plane-strain", "smoothing = { ratio = 1.2 }\n" + square + disc_at(1.65, "other"));
  const auto& particles = result.snapshot.particles;
  REQUIRE(particles.bodies().size() == 2);
  CHECK(particles.bodies()[0].name == "a");
  CHECK(particles.bodies()[1].range.begin == 100);
  CHECK(particles.integers(Field::id)[150] == 150);
  CHECK(particles.reals(Field::density)[99] == 1.0);
  CHECK(particles.reals(Field::density)[100] == 2.0);
  CHECK(particles.reals(Field::smoothing_length)[0] == Approx(0.12).epsilon(1e-15));
  CHECK(result.snapshot.time() == 0.0);
  CHECK_THAT(result.snapshot.scene, Catch::Contains("cell-centred"));  // defaults are in the effective scene
}

TEST_CASE("Particles: the mass is that of the cells, or the exact one on request") {
  const std::string disc = "[body.a]\nmaterial = 'unit'\nshape = { type = 'disc', radius = 1 }\n";
  const auto cells = result_of("plane-stress", disc);
  const auto& report = cells.bodies[0];
  CHECK(report.mass == Approx(0.01 * static_cast<double>(report.count)));
  CHECK(report.mass != Approx(M_PI).epsilon(1e-6));
  const auto exact = result_of("plane-stress", disc + "arrangement = { mass = 'exact' }\n");
  CHECK(exact.bodies[0].mass == Approx(M_PI).epsilon(1e-12));
  CHECK_THAT(preprocess::in_words(exact), Catch::Contains("spread over the particles"));
}

TEST_CASE("Particles: a body that the spacing does not fit is warned of, where its mass is off by more than a tenth") {
  const auto plate_of = [](const std::string& thickness, const std::string& mass = "cell") {
    return result_of("plane-strain",
                     "[body.a]\nmaterial = 'unit'\nshape = { type = 'rectangle', lower = [0, 0], upper = [" +
                         thickness + ", 2] }\narrangement = { type = 'lattice', mass = '" + mass + "' }\n");
  };
  using Catch::Contains;
  // Spacing 0.1: one column of particles for 0.14, two for 0.19, ten for 1.04.
  const auto thin = plate_of("0.14"), thicker = plate_of("0.19");
  REQUIRE(thin.bodies[0].warnings.size() == 1);
  CHECK_THAT(thin.bodies[0].warnings.front(), Contains("29 % less mass") && Contains("a spacing that divides"));
  CHECK(plate_of("0.14", "exact").bodies[0].warnings.empty());
  CHECK(thicker.bodies[0].warnings.empty());
  CHECK(plate_of("1.04").bodies[0].warnings.empty());
}

TEST_CASE("Symmetry: a lattice that does not fit a plane is warned of, with place, distance and what helps") {
  const auto warnings_of = [](const std::string& radius, const std::string& convention) {
    return result_of("plane-strain", "[body.a]\nmaterial = 'unit'\nshape = { type = 'disc', radius = " + radius +
                                         " }\narrangement = { type = 'lattice', convention = '" + convention +
                                         "' }\n[symmetry.p]\naxis = 'y'\n");
  };
  using Catch::Contains;
  const auto near = warnings_of("0.54", "cell-centred");
  REQUIRE_FALSE(near.bodies[0].warnings.empty());
  CHECK_THAT(preprocess::in_words(near), Contains("body a ") && Contains("warning: ") &&
                                             Contains("plane y = 0 m lie 0.01 m from it, 0.1 spacings") &&
                                             Contains("too near to their own images") &&
                                             Contains("a spacing that divides") && Contains("origin"));
  CHECK(warnings_of("0.5", "cell-centred").bodies[0].warnings.empty());
  CHECK(warnings_of("0.55", "cell-centred").bodies[0].warnings.empty());  // a row on the plane
  for (const auto* convention : {"on-origin", "half-off-origin", "edges-included"})
    CHECK(warnings_of("0.54", convention).bodies[0].warnings.empty());
}

TEST_CASE("Symmetry: a gap before the images is warned of, and a body that lies off the plane is not") {
  const auto warnings_of = [](double lower) {
    return result_of("line",
                     "[body.a]\nmaterial = 'unit'\nshape = { type = 'segment', lower = " + std::to_string(lower) +
                         ", upper = 1 }\narrangement = { type = 'lattice', convention = 'on-origin', "
                         "origin = [0.07] }\n[symmetry.p]\naxis = 'x'\n")
        .bodies[0]
        .warnings;
  };
  REQUIRE(warnings_of(0.0).size() == 1);
  CHECK_THAT(warnings_of(0.0).front(), Catch::Contains("0.7 spacings, which leaves a gap before their images"));
  CHECK(warnings_of(0.03).empty());
}

TEST_CASE("Symmetry: particles on a plane stay with half their mass a plane, and cannot leave it") {
  const std::string body =
      "[body.a]\nmaterial = 'unit'\nvelocity = [1, 2, 3]\n"
      "shape = { type = 'box', lower = [-0.25, -0.25, -0.25], upper = [0.25, 0.25, 0.25] }\n";
  const auto result = result_of("solid", body + "[symmetry.p]\naxis = 'y'\n[symmetry.q]\naxis = 'z'\nkeep = 'below'\n");
  const auto& particles = result.snapshot.particles;
  CHECK(particles.count() == 5 * 3 * 3);
  CHECK(sum(particles.reals(Field::mass)) == Approx(0.125 / 4).epsilon(1e-12));
  CHECK(result.bodies[0].exact_mass == Approx(0.125 / 4).epsilon(1e-12));
  CHECK(result.bodies[0].on_symmetry_planes == 5 * 5);
  for (std::size_t k = 0; k < particles.count(); ++k) {
    const auto* x = &particles.reals(Field::position)[3 * k];
    const auto* v = &particles.reals(Field::velocity)[3 * k];
    CHECK(v[0] == 1.0);
    CHECK(v[1] == (x[1] == 0.0 ? 0.0 : 2.0));
    CHECK(v[2] == (x[2] == 0.0 ? 0.0 : 3.0));
    CHECK((x[1] >= 0.0 && x[2] <= 0.0));
  }
}

TEST_CASE("Particles: one of them is told in the singular") {
  const auto told = preprocess::in_words(
      result_of("plane-strain",
                "[body.a]\nmaterial = 'unit'\nshape = { type = 'rectangle', lower = [0, 0], upper = [0.1, 0.1] }\n"));
  CHECK_THAT(told, Catch::StartsWith("body a (unit): 1 particle at ") && Catch::Contains("1 particle in all"));
}

TEST_CASE("Particles: the same on any number of threads") {
  const std::string body =
      "[body.a]\nmaterial = 'unit'\nshape = { type = 'sphere', radius = 1.3 }\narrangement = { type = 'close-packed' "
      "}\n";
  std::vector<double> first;
  for (const int threads : {1, 3}) {
    omp_set_num_threads(threads);
    const auto result = result_of("solid", body);
    const auto positions = result.snapshot.particles.reals(Field::position);
    if (first.empty()) first.assign(positions.begin(), positions.end());
    CHECK(std::equal(positions.begin(), positions.end(), first.begin(), first.end()));
  }
  omp_set_num_threads(omp_get_num_procs());
}

TEST_CASE("Bodies: touching is allowed, overlapping is not") {
  CHECK_NOTHROW(result_of("plane-strain", square + disc_at(1.5, "other")));
  CHECK_THAT(fault_of([] { result_of("plane-strain", square + disc_at(1.3, "other")); }),
             Catch::Contains("overlaps") && Catch::Contains("body a") && Catch::Contains("body b"));
  const std::string other =
      "[body.b]\nmaterial = 'other'\nshape = { type = 'rectangle', lower = [1.01, 0], upper = [2.01, 1] }\n"
      "arrangement = { convention = 'edges-included' }\n";
  // particles at x = 0.95 and 1.01, y = 0.05 and 0: 0.078 apart; shifted by half a spacing they meet within 0.06 only
  CHECK_NOTHROW(result_of("plane-strain", square + other));
  const std::string edge = "arrangement = { convention = 'edges-included' }\n";
  CHECK_THAT(fault_of([&] { result_of("plane-strain", square + edge + other); }),
             Catch::Contains("nearer than half a spacing"));
}

TEST_CASE("Bodies: an overlap by less than what the particles are within their faces is refused too") {
  const auto plate_at = [](const std::string& x) {
    return square + "[body.b]\nmaterial = 'other'\nshape = { type = 'rectangle', lower = [" + x +
           ", 0], upper = [2, 1] }\n";
  };
  // Spacing 0.1: particles half a spacing within the faces, so that none lies in the other body.
  for (const auto* x : {"0.95", "0.98", "0.985"})
    CHECK_THAT(fault_of([&] { result_of("plane-strain", plate_at(x)); }),
               Catch::Contains("overlaps") && Catch::Contains("a reaches into b by more than 0.1 spacings"));
  CHECK_NOTHROW(result_of("plane-strain", plate_at("0.995")));
  CHECK_NOTHROW(result_of("plane-strain", plate_at("1.0")));
  // The corner of a square that stands on its tip, in touch.
  const auto on_tip = [](double x) {
    return square +
           "[body.b]\nmaterial = 'other'\nshape = { type = 'rectangle', lower = [-0.5, -0.5], upper = [0.5, 0.5], "
           "rotate = { angle = '45 deg' }, translate = [" +
           std::to_string(x) + ", 0.5] }\n";
  };
  CHECK_NOTHROW(result_of("plane-strain", on_tip(1.0 + std::sqrt(0.5))));
  // A ball in a box with a hole for it, and one that is too small.
  const auto in_hole = [](const std::string& radius) {
    return "[body.a]\nmaterial = 'unit'\nshape = { type = 'disc', radius = 1 }\n[body.b]\nmaterial = 'other'\n"
           "shape = { type = 'difference', parts = [{ type = 'rectangle', lower = [-2, -2], upper = [2, 2] }, "
           "{ type = 'disc', radius = " +
           radius + " }] }\n";
  };
  CHECK_NOTHROW(result_of("plane-strain", in_hole("1.05")));
  CHECK_NOTHROW(result_of("plane-strain", in_hole("1")));
  CHECK_THAT(fault_of([&] { result_of("plane-strain", in_hole("0.97")); }), Catch::Contains("overlaps"));
}

TEST_CASE("Bodies: what cannot be filled is refused with the reason") {
  const auto fault = [](const std::string& space, const std::string& rest) {
    return fault_of([&] { result_of(space, rest); });
  };
  CHECK_THAT(fault("plane-strain", "[body.a]\nmaterial = 'unit'\nshape = { type = 'disc', radius = '1 mm' }\n"),
             Catch::Contains("thinner than one spacing"));
  CHECK_THAT(fault("plane-strain", "[body.a]\nmaterial = 'unit'\nshape = { type = 'disc', radius = '10 km' }\n"),
             Catch::Contains("particles at a spacing"));
  CHECK_THAT(fault("plane-strain", square + "[symmetry.p]\naxis = 'x'\nat = 2.0\n"),
             Catch::Contains("wholly beyond a symmetry plane"));
  CHECK_THAT(fault("plane-strain", "[body.a]\nmaterial = 'gold'\nshape = { type = 'disc', radius = 1 }\n"),
             Catch::Contains("other, unit"));
  CHECK_THAT(fault("plane-strain", square + "arrangement = { type = 'rings' }\n"), Catch::Contains("disc, ring"));
  CHECK_THAT(fault("plane-strain", square + "spacing = 0.1\narrangement = { count = 100 }\n"),
             Catch::Contains("one of the two"));
  CHECK_THAT(fault("plane-strain", square + "colour = 'red'\n"), Catch::Contains("unknown key"));
  CHECK_THAT(fault("plane-strain", ""), Catch::Contains("no body"));
  const std::string between =
      "[body.a]\nmaterial = 'unit'\nshape = { type = 'difference', parts = [{ type = 'rectangle', lower = [0, 0], "
      "upper = [0.3, 0.3] }, { type = 'rectangle', lower = [0.04, 0.04], upper = [0.26, 0.26] }] }\n";
  CHECK_NOTHROW(result_of("plane-strain", between + "arrangement = { convention = 'edges-included' }\n"));
  CHECK_THAT(fault("plane-strain", between + "arrangement = { convention = 'on-origin', origin = [0.05, 0.05] }\n"),
             Catch::Contains("no particle falls inside"));
}

TEST_CASE("About an axis: cells that are stretched on to it have the mass of what they sweep", "[axis]") {
  // radii 0, 0.11, ..., 0.99 where steps of 0.107 were asked for; the last cell reaches to 1.045
  const auto segment = [](const std::string& space) {
    return result_of(space,
                     "[body.a]\nmaterial = 'unit'\nshape = { type = 'segment', lower = 0, upper = 0.99 }\n"
                     "spacing = 0.107\narrangement = { type = 'lattice', convention = 'edges-included' }\n");
  };
  CHECK(segment("cylindrical").bodies[0].mass == Approx(M_PI * 1.045 * 1.045).epsilon(1e-12));
  CHECK(segment("spherical").bodies[0].mass == Approx(4.0 / 3.0 * M_PI * std::pow(1.045, 3)).epsilon(1e-12));
}

TEST_CASE("About an axis: the exact mass is that of the solid, told and given on request", "[axis]") {
  const auto rod = [](const std::string& mass) {
    return result_of("axisymmetric",
                     "[body.a]\nmaterial = 'unit'\nshape = { type = 'rectangle', lower = [0, 0], upper = [1, 2] }\n"
                     "arrangement = { type = 'lattice', convention = 'edges-included', mass = '" +
                         mass + "' }\n");
  };
  const auto cells = rod("cell");
  CHECK(cells.bodies[0].mass == Approx(M_PI * 1.05 * 1.05 * 2.1).epsilon(1e-12));
  CHECK(cells.bodies[0].exact_mass == Approx(2 * M_PI).epsilon(1e-12));
  CHECK_THAT(preprocess::in_words(cells), Catch::Contains("exact 6.28319 kg, difference +15.763 %"));
  CHECK(rod("exact").bodies[0].mass == Approx(2 * M_PI).epsilon(1e-12));
}
