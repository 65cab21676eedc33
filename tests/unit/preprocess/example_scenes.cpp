// The scenes in examples/ give the particles that their sources count.
#include <catch2/catch.hpp>
#include <numeric>
#include <string>

#include "preprocess/build_particles.hpp"

using namespace tektite;

namespace {

preprocess::Result example(const std::string& name, const std::string& variant) {
  auto document = Document::load(std::string(EXAMPLES) + "/" + name + "/scene.toml", variant, {});
  return preprocess::build_particles(document);
}

std::int64_t sum(std::span<const std::int64_t> values) {
  return std::accumulate(values.begin(), values.end(), std::int64_t{0});
}

}  // namespace

TEST_CASE("hvi_2d: 7830 particles in the disc and 10 020 in the plate, without fields of regions") {
  const auto result = example("hvi_2d", "sav1");
  CHECK(result.bodies[0].count == 7830);
  CHECK(result.bodies[1].count == 10020);
  CHECK_FALSE(result.snapshot.particles.has(Field::kernel_type));
  CHECK_FALSE(result.snapshot.particles.has(Field::clamped));
}

TEST_CASE("tensile_patch: 100 x 100 particles, a quarter of them under tension, the upper half Eulerian if coupled") {
  const std::string variant = GENERATE("total_lagrangian", "eulerian", "eulerian_artificial_stress", "coupled",
                                       "coupled_interface_none", "coupled_interface_eulerian");
  const auto result = example("tensile_patch", variant);
  const auto& particles = result.snapshot.particles;
  CHECK(particles.count() == 10000);
  CHECK(result.bodies[0].regions[0].count == 2500);
  const bool coupled = variant.starts_with("coupled");
  REQUIRE(particles.has(Field::kernel_type) == coupled);
  if (coupled) CHECK(sum(particles.integers(Field::kernel_type)) == 5000);
}

TEST_CASE("debris_3d: 912 particles in the sphere, 30 000 in the plate, its outermost ones clamped") {
  const std::string variant = GENERATE("", "adaptle", "eulerian", "total_lagrangian", "patch");
  const auto result = example("debris_3d", variant);
  const auto& particles = result.snapshot.particles;
  CHECK(result.bodies[0].count == 912);
  CHECK(result.bodies[1].count == 30000);
  CHECK(sum(particles.integers(Field::clamped)) == 3 * (100 * 100 - 98 * 98));
  REQUIRE(particles.has(Field::kernel_type) == (variant == "patch"));
  if (variant == "patch") CHECK(sum(particles.integers(Field::kernel_type)) == 16 * 16 * 3);
}

TEST_CASE("debris_3d: a quarter has a quarter of the particles and none on a symmetry plane") {
  const auto result = example("debris_3d", "quarter");
  CHECK(result.bodies[0].count == 228);
  CHECK(result.bodies[1].count == 7500);
  CHECK(result.bodies[0].on_symmetry_planes + result.bodies[1].on_symmetry_planes == 0);
  CHECK(sum(result.snapshot.particles.integers(Field::clamped)) == 3 * (50 * 50 - 49 * 49));
}

TEST_CASE("ceramic_tile: 51 842 particles; half of it has the rows on one side of the plane and half of those on it") {
  const auto result = example("ceramic_tile", "split2");
  CHECK(result.bodies[0].count == 3321);
  CHECK(result.bodies[1].count == 48521);
  const auto half = example("ceramic_tile", "half");
  CHECK(half.bodies[0].count == 81 * 21);
  CHECK(half.bodies[1].count == 201 * 121);
  CHECK(half.bodies[0].on_symmetry_planes == 81);
  CHECK(half.bodies[1].on_symmetry_planes == 121);
}

TEST_CASE("collapsing_ring: 17 and 29 circles with the mass of the ring to a ten-thousandth") {
  const auto [variant, count] = GENERATE(table<std::string, int>({{"split2", 8172}, {"split2_fine", 23780}}));
  const auto result = example("collapsing_ring", variant);
  CHECK(result.bodies[0].count == static_cast<std::size_t>(count));
  const auto mass = result.snapshot.particles.reals(Field::mass);
  const double exact = 1845.0 * 3.14159265358979 * (0.1 * 0.1 - 0.08 * 0.08);
  CHECK(std::accumulate(mass.begin(), mass.end(), 0.0) == Approx(exact).epsilon(1.5e-4));  // whole particles on circles
}

TEST_CASE("taylor_bar: 20 x 191 particles in test 7, and 31 x 301 in the finer one") {
  CHECK(example("taylor_bar", "").snapshot.particles.count() == 3820);
  CHECK(example("taylor_bar", "particles_31").snapshot.particles.count() == 31 * 301);
}

TEST_CASE("taylor_bar: a ring has the mass of its section times the way around the axis") {
  const auto result = example("taylor_bar", "");
  const auto& p = result.snapshot.particles;
  double sum = 0.0;
  for (const double m : p.reals(Field::mass)) sum += m;
  // Edges included: the outermost particles have whole cells, half a spacing beyond mantle and ends.
  const double spacing = 3.7975e-3 / 19.0, radius = 3.7975e-3 + 0.5 * spacing, length = 191.0 * 37.97e-3 / 190.0;
  // The axis' half cell counts as its mean radius, which makes the disc exact; δ differs from L/190 by 2e-4.
  CHECK(sum == Approx(7830.0 * M_PI * radius * radius * length).epsilon(1e-3));
}
