#include <catch2/catch.hpp>
#include <numeric>

#include "scene_text.hpp"
#include "support/fault.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

/// A square of 10 x 10 particles on 0 ≤ x, y ≤ 1, with what stands below [body.a].
std::string square(const std::string& rest) {
  return "[body.a]\nmaterial = 'unit'\nshape = { type = 'rectangle', lower = [0, 0], upper = [1, 1] }\n" + rest;
}

std::string region(const std::string& name, const std::string& lower, const std::string& upper,
                   const std::string& rest) {
  return "[body.a.region." + name + "]\nshape = { type = 'rectangle', lower = " + lower + ", upper = " + upper +
         " }\n" + rest + "\n";
}

double sum(std::span<const double> values) { return std::accumulate(values.begin(), values.end(), 0.0); }
std::int64_t sum(std::span<const std::int64_t> values) {
  return std::accumulate(values.begin(), values.end(), std::int64_t{0});
}

}  // namespace

TEST_CASE("Regions: a density holds inside, and a particle's mass is that of its cell at this density") {
  const auto result =
      result_of("plane-strain", square(region("patch", "[0.3, 0.3]", "[0.6, 0.7]", "density = '0.5 kg/m3'")));
  const auto& particles = result.snapshot.particles;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < particles.count(); ++i) {
    const auto* x = &particles.reals(Field::position)[2 * i];
    const bool within = x[0] > 0.3 && x[0] < 0.6 && x[1] > 0.3 && x[1] < 0.7;
    inside += within;
    CHECK(particles.reals(Field::density)[i] == (within ? 0.5 : 1.0));
    CHECK(particles.reals(Field::mass)[i] == Approx(within ? 0.005 : 0.01).epsilon(1e-14));
  }
  CHECK(inside == 12);
  REQUIRE(result.bodies[0].regions.size() == 1);
  CHECK(result.bodies[0].regions[0].count == 12);
  CHECK_FALSE(particles.has(Field::kernel_type));
  CHECK_FALSE(particles.has(Field::clamped));
}

TEST_CASE("Regions: an energy holds inside, and elsewhere there is none") {
  const auto result =
      result_of("plane-strain", square(region("hot", "[0, 0]", "[0.5, 1]", "specific_internal_energy = '2.5 kJ/kg'")));
  const auto& particles = result.snapshot.particles;
  REQUIRE(particles.has(Field::specific_internal_energy));
  for (std::size_t i = 0; i < particles.count(); ++i)
    CHECK(particles.reals(Field::specific_internal_energy)[i] ==
          (particles.reals(Field::position)[2 * i] < 0.5 ? 2500.0 : 0.0));
}

TEST_CASE("Regions: the exact mass takes each region at its own density") {
  const auto body = square(region("half", "[0, 0]", "[0.5, 1]", "density = 3"));
  CHECK(result_of("plane-strain", body).bodies[0].exact_mass == Approx(2.0).epsilon(1e-12));
  const auto spread =
      result_of("plane-strain", square("arrangement = { convention = 'edges-included', mass = 'exact' }\n" +
                                       region("half", "[0, 0]", "[0.45, 1]", "density = 3")));
  // 11 x 11 particles share an area of 1; 5 of 11 columns have the density 3
  CHECK(sum(spread.snapshot.particles.reals(Field::mass)) == Approx((5 * 3.0 + 6 * 1.0) / 11).epsilon(1e-12));
}

TEST_CASE("Regions: kernels are total-Lagrangian but where a region says otherwise") {
  const auto result =
      result_of("plane-strain", square(region("top", "[0, 0.5]", "[1, 1]", "kernel = 'eulerian'")) +
                                    "[body.b]\nmaterial = 'other'\nshape = { type = 'disc', centre = [5, 5], radius = "
                                    "0.5 }\n");
  const auto& particles = result.snapshot.particles;
  REQUIRE(particles.has(Field::kernel_type));
  CHECK_FALSE(particles.has(Field::clamped));
  for (std::size_t i = 0; i < particles.count(); ++i) {
    const bool top = i < 100 && particles.reals(Field::position)[2 * i + 1] > 0.5;
    const auto expected = top ? KernelType::eulerian : KernelType::total_lagrangian;
    CHECK(particles.integers(Field::kernel_type)[i] == static_cast<std::int64_t>(expected));
  }
}

TEST_CASE("Regions: where two of them share a particle the later one decides") {
  const auto left = region("left", "[0, 0]", "[0.6, 1]", "kernel = 'eulerian'\ndensity = 2");
  const auto right = region("right", "[0.4, 0]", "[1, 1]", "kernel = 'total-lagrangian'");
  const auto eulerian = [](const std::string& regions) {
    const auto result = result_of("plane-strain", square(regions));
    CHECK(sum(result.snapshot.particles.reals(Field::density)) == Approx(160.0));  // what right leaves open stays
    return sum(result.snapshot.particles.integers(Field::kernel_type));
  };
  CHECK(eulerian(left + right) == 40);
  CHECK(eulerian(right + left) == 60);
}

TEST_CASE("Regions: the order survives in the effective scene") {
  const auto first =
      result_of("plane-strain", square(region("zebra", "[0, 0]", "[0.6, 1]", "kernel = 'eulerian'") +
                                       region("ant", "[0.4, 0]", "[1, 1]", "kernel = 'total-lagrangian'")));
  auto effective = Document::parse(first.snapshot.scene, "particles.h5");
  const auto second = preprocess::build_particles(effective);
  CHECK(sum(second.snapshot.particles.integers(Field::kernel_type)) == 40);
}

TEST_CASE("Regions: clamped particles stand still in a body that moves") {
  const auto frame =
      "velocity = [1, 0]\n[body.a.region.edge]\nclamped = true\nshape = { type = 'difference', parts = [{ type = "
      "'rectangle', lower = [0, 0], upper = [1, 1] }, { type = 'rectangle', lower = [0.1, 0.1], upper = [0.9, 0.9] "
      "}] }\n";
  const auto result = result_of("plane-strain", square(frame));
  const auto& particles = result.snapshot.particles;
  CHECK(sum(particles.integers(Field::clamped)) == 36);
  for (std::size_t i = 0; i < particles.count(); ++i)
    CHECK(particles.reals(Field::velocity)[2 * i] == (particles.integers(Field::clamped)[i] == 1 ? 0.0 : 1.0));
  const auto freed =
      result_of("plane-strain", square(frame + region("gate", "[0, 0.4]", "[0.1, 0.6]", "clamped = false")));
  CHECK(sum(freed.snapshot.particles.integers(Field::clamped)) == 34);
}

TEST_CASE("Regions: a velocity of any kind replaces that of the body, but never across a symmetry plane") {
  const auto spin =
      region("core", "[0, 0]", "[0.5, 0.5]", "velocity = { type = 'rotation', rate = 10, centre = [0, 0] }");
  const auto result = result_of("plane-strain", square("velocity = [3, 4]\narrangement = { convention = "
                                                       "'edges-included' }\n" +
                                                       spin + "[symmetry.middle]\naxis = 'y'\n"));
  const auto& particles = result.snapshot.particles;
  for (std::size_t i = 0; i < particles.count(); ++i) {
    const auto* x = &particles.reals(Field::position)[2 * i];
    const auto* v = &particles.reals(Field::velocity)[2 * i];
    const bool within = x[0] < 0.55 && x[1] < 0.55, on_plane = x[1] == 0.0;
    CHECK(v[0] == Approx(within ? -10.0 * x[1] : 3.0).margin(1e-12));
    CHECK(v[1] == Approx(on_plane ? 0.0 : within ? 10.0 * x[0] : 4.0).margin(1e-12));
  }
}

TEST_CASE("Regions: a particle on the edge is inside") {
  const auto body = square("arrangement = { convention = 'edges-included' }\n" +
                           region("column", "[0.3, 0]", "[0.3000000001, 1]", "kernel = 'eulerian'"));
  CHECK(result_of("plane-strain", body).bodies[0].regions[0].count == 11);
}

TEST_CASE("Regions: the report says how many particles each has and what it asks for") {
  const auto words = preprocess::in_words(result_of(
      "plane-strain", square(region("top", "[0, 0.5]", "[1, 1]", "kernel = 'eulerian'\ndensity = '0.88 kg/m3'") +
                             region("foot", "[0, 0]", "[1, 0.1]", "clamped = true"))));
  CHECK_THAT(words, Catch::Contains("region top: 50 particles, density 0.88 kg/m3, eulerian kernel"));
  CHECK_THAT(words, Catch::Contains("region foot: 10 particles, clamped"));
}

TEST_CASE("Regions: what cannot be meant is refused with the reason") {
  const auto fault = [](const std::string& regions) {
    return fault_of([&] { result_of("plane-strain", square(regions)); });
  };
  CHECK_THAT(fault(region("far", "[3, 3]", "[4, 4]", "clamped = true")),
             Catch::Contains("body.a.region.far.shape") && Catch::Contains("no particle"));
  CHECK_THAT(fault(region("idle", "[0, 0]", "[1, 1]", "")),
             Catch::Contains("asks for nothing") &&
                 Catch::Contains("density, specific_internal_energy, kernel, clamped, velocity"));
  CHECK_THAT(fault(region("odd", "[0, 0]", "[1, 1]", "kernel = 'lagrangian'")),
             Catch::Contains("total-lagrangian, eulerian"));
  CHECK_THAT(fault(region("odd", "[0, 0]", "[1, 1]", "density = '-1 kg/m3'")), Catch::Contains("out of range"));
  CHECK_THAT(fault(region("odd", "[0, 0]", "[1, 1]", "clamped = true\nvelocity = [1, 0]")),
             Catch::Contains("does not move"));
  CHECK_THAT(fault(region("odd", "[0, 0]", "[1, 1]", "clamped = 1")), Catch::Contains("true, false"));
  CHECK_THAT(fault(region("odd", "[0, 0]", "[1, 1]", "clamped = true\ncolour = 'red'")),
             Catch::Contains("unknown key"));
  CHECK_THAT(fault("[body.a.region.bare]\nclamped = true\n"),
             Catch::Contains("body.a.region.bare.shape") && Catch::Contains("missing"));
}
