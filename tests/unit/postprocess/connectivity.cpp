// Fragments: what hangs together and what does not.

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <set>
#include <utility>

#include "postprocess/measure/connectivity.hpp"
#include "postprocess/measure/point_grid.hpp"
#include "unit/postprocess/synthetic.hpp"

namespace tektite::test {
namespace {

Whole row_of(const std::vector<double>& positions, const std::vector<std::string>& bodies) {
  std::vector<Placed> placed;
  for (std::size_t i = 0; i < positions.size(); ++i) placed.push_back({bodies[i], {positions[i], 0, 0}, {1.0, 0, 0}});
  return make_whole(snapshot_of(Space::line, placed, 0.0, "", as_it_is), {});
}

}  // namespace

TEST_CASE("Connectivity: particles belong together while they are nearer than the link times their smoothing length") {
  const double h = 1.4 * spacing;
  const auto whole = row_of({0.0, 0.99 * h, 0.99 * h + 1.01 * h, 5 * h, 6.99 * h}, {"a", "a", "a", "a", "a"});
  CHECK(find_fragments(whole, 1.0).list.size() == 4);
  CHECK(find_fragments(whole, 2.0).list.size() == 2);
  CHECK(find_fragments(whole, 3.1).list.size() == 1);
}

TEST_CASE("Connectivity: bodies that touch are not one fragment") {
  const auto whole = row_of({0.0, 1e-3, 2e-3, 3e-3}, {"a", "a", "b", "b"});
  const auto fragments = find_fragments(whole, 2.0);
  REQUIRE(fragments.list.size() == 2);
  CHECK(fragments.list[fragments.heaviest(0)].body == 0);
  CHECK(fragments.list[fragments.heaviest(1)].body == 1);
}

TEST_CASE("Connectivity: asking for a body without particles is an error of the program") {
  CHECK_THROWS_WITH(find_fragments(row_of({0.0}, {"a"}), 2.0).heaviest(1), "a body has no particles");
}

TEST_CASE("Connectivity: fragments come the heaviest first, with mass, centre and velocity") {
  const auto whole = row_of({0.0, 0.1, 0.101, 0.102}, {"a", "a", "a", "a"});
  const auto fragments = find_fragments(whole, 2.0);
  REQUIRE(fragments.list.size() == 2);
  CHECK(fragments.list[0].count == 3);
  CHECK(fragments.list[0].mass == Approx(3 * 2785.0 * spacing));
  CHECK(fragments.list[0].centre[0] == Approx(0.101));
  CHECK(fragments.list[0].velocity[0] == Approx(1.0));
  CHECK(fragments.label[0] == 1);
  CHECK(fragments.label[3] == 0);
}

TEST_CASE("Connectivity: a ring is one piece with its own mass, on both sides of the axis") {
  std::vector<Placed> placed;
  for (const double x : {0.5e-3, 1.5e-3}) placed.push_back({"rod", {x, 20e-3, 0}, {0.0, 3.0, 0}});
  for (const double x : {10e-3, 11e-3, 12e-3}) placed.push_back({"rod", {x, 20e-3, 0}, {7.0, 5.0, 0}});
  const auto snapshot = snapshot_of(Space::axisymmetric, placed, 0.0, "", as_it_is);
  const SymmetryPlane axis{0, 0.0, 1.0}, below{1, 0.0, 1.0};
  const double particle = 2785.0 * spacing * spacing;
  const auto whole = find_fragments(make_whole(snapshot, {axis}), 2.0);
  REQUIRE(whole.list.size() == 2);
  CHECK(whole.list[0].count == 3);
  CHECK(whole.list[0].mass == Approx(3 * particle));
  CHECK(whole.list[0].centre[0] == Approx(0.0).margin(1e-12));
  CHECK(whole.list[0].centre[1] == Approx(20e-3));
  CHECK(whole.list[0].velocity[0] == Approx(0.0).margin(1e-12));
  CHECK(whole.list[0].velocity[1] == Approx(5.0));
  CHECK(whole.list[1].count == 2);
  CHECK(whole.list[1].mass == Approx(2 * particle));
  const auto both = find_fragments(make_whole(snapshot, {below, axis}), 2.0);  // a ring above the plane, one below
  REQUIRE(both.list.size() == 4);
  CHECK(both.list[0].mass == Approx(3 * particle));
  CHECK(both.list[1].mass == Approx(3 * particle));
  CHECK(both.list[3].count == 2);
}

TEST_CASE("Connectivity: the grid finds the fragments that comparing every pair finds") {
  // A cloud from a linear congruential generator, dense enough for fragments of many sizes.
  std::vector<Placed> placed;
  std::uint32_t state = 1;
  const auto next = [&] { return static_cast<double>((state = state * 1664525u + 1013904223u) >> 8) / (1 << 24); };
  for (int i = 0; i < 600; ++i) {
    const double x = next();
    const double y = next();
    placed.push_back({"cloud", {0.02 * (x - 0.5), 0.02 * (y - 0.5), 0.02 * (next() - 0.5)}, {0, 0, 0}});
  }
  const auto whole = make_whole(snapshot_of(Space::solid, placed, 0.0, "", as_it_is), {});
  const auto fragments = find_fragments(whole, 1.0);
  REQUIRE(fragments.list.size() > 50);
  REQUIRE(fragments.list.size() < 550);
  std::vector<std::uint32_t> label(whole.count());
  for (std::uint32_t i = 0; i < label.size(); ++i) label[i] = i;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < label.size(); ++i)
      for (std::size_t j = 0; j < label.size(); ++j)
        if (label[j] > label[i] && norm(whole.position[i] - whole.position[j]) < 1.4 * spacing) {
          label[j] = label[i];
          changed = true;
        }
  }
  for (std::size_t i = 0; i < label.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if ((label[i] == label[j]) != (fragments.label[i] == fragments.label[j])) FAIL("pair " << i << ", " << j);
}

TEST_CASE("Point grid: every two points that are nearer than a cell are visited, and none twice") {
  for (const int dimensions : {1, 2, 3}) {
    std::mt19937 random(20260 + dimensions);
    std::uniform_real_distribution<double> place(-3.0, 3.0);
    std::vector<Point> points(300, Point::zero());
    for (auto& point : points)
      for (int k = 0; k < dimensions; ++k) point[k] = place(random);
    constexpr double cell = 0.9;
    std::set<std::pair<std::uint32_t, std::uint32_t>> visited;
    PointGrid(points, cell).for_each_pair(dimensions, [&](std::uint32_t i, std::uint32_t j) {
      if (i == j || !visited.insert(std::minmax(i, j)).second) FAIL("pair " << i << ", " << j);
    });
    for (std::uint32_t i = 0; i < points.size(); ++i)
      for (std::uint32_t j = i + 1; j < points.size(); ++j)
        if (norm(points[i] - points[j]) < cell && !visited.contains({i, j})) FAIL("missing " << i << ", " << j);
    CHECK(visited.size() < points.size() * (points.size() - 1) / 2);
  }
}

}  // namespace tektite::test
