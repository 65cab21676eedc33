// The search of neighbours against all pairs.
#include "neighbours/pair_list.hpp"

#include <omp.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <ranges>
#include <set>

#include "boundary/mirror.hpp"
#include "core/pack.hpp"

using namespace tektite;

namespace {

template <int D>
using Places = std::vector<Vector<double, D>>;

template <int D>
Places<D> random_places(std::size_t count, double extent, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(0.0, extent);
  Places<D> places(count);
  for (auto& x : places)
    for (int k = 0; k < D; ++k) x[k] = number(generator);
  return places;
}

template <int D>
Places<D> lattice_places(int side) {
  Places<D> places;
  const int count = D == 1 ? side : D == 2 ? side * side : side * side * side;
  for (int n = 0; n < count; ++n) {
    Vector<double, D> x;
    for (int k = 0, rest = n; k < D; ++k, rest /= side) x[k] = rest % side;
    places.push_back(x);
  }
  return places;
}

template <int D>
PairList listed(const Places<D>& places, std::size_t count, const Reach& reach) {
  CellGrid<D> grid;
  grid.build(places, reach.all);
  PairList list;
  const std::vector<std::uint32_t> body(places.size(), 0);
  list.build<D>(grid, places, count, reach, Pairing::all, body);
  return list;
}

/// The neighbours of particle i as they stand in the list, its filling with i itself included.
std::vector<std::uint32_t> row(const PairList& list, std::size_t i) {
  for (const auto& block : list.blocks())
    if (i >= block.begin && i - block.begin + 1 < block.first.size()) {
      const auto* data = block.neighbours.data();
      return {data + block.first[i - block.begin], data + block.first[i - block.begin + 1]};
    }
  return {};
}

/// Whether the list holds each near particle once, nothing else, and whole packs.
template <int D>
void check_against_all_pairs(const Places<D>& places, std::size_t count, double reach) {
  const auto list = listed<D>(places, count, reach);
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < count; ++i) {
    auto found = row(list, i);
    REQUIRE(found.size() % pack_width == 0);
    const auto filling = static_cast<std::size_t>(std::ranges::count(found, static_cast<std::uint32_t>(i)));
    REQUIRE(filling < pack_width);
    std::erase(found, static_cast<std::uint32_t>(i));
    std::ranges::sort(found);
    std::vector<std::uint32_t> expected;
    for (std::size_t j = 0; j < places.size(); ++j) {
      const auto x = places[i] - places[j];
      if (j != i && dot(x, x) < reach * reach) expected.push_back(static_cast<std::uint32_t>(j));
    }
    REQUIRE(found == expected);
    pairs += found.size();
  }
  CHECK(pairs > 0);
}

/// Places with a dense heap and fragments that have flown off by up to 1e9 times the reach.
template <int D>
Places<D> with_fragments(std::size_t count) {
  auto places = random_places<D>(count, 6.0, 11);
  std::mt19937 generator(12);
  std::uniform_real_distribution<double> power(1.0, 9.0), sign(-1.0, 1.0);
  for (std::size_t i = 0; i < count; i += 5)
    for (int k = 0; k < D; ++k) places[i][k] = (sign(generator) < 0.0 ? -1.0 : 1.0) * std::pow(10.0, power(generator));
  return places;
}

}  // namespace

TEST_CASE("Neighbours: on random places the list is that of all pairs", "[neighbours]") {
  check_against_all_pairs<1>(random_places<1>(700, 100.0, 1), 700, 1.3);
  check_against_all_pairs<2>(random_places<2>(900, 20.0, 2), 900, 1.3);
  check_against_all_pairs<3>(random_places<3>(1000, 8.0, 3), 1000, 1.3);
}

TEST_CASE("Neighbours: on lattices the list is that of all pairs", "[neighbours]") {
  // 2.8 spacings, and no lattice distance within rounding of it: 2√2 = 2.828, √7.84.
  check_against_all_pairs<1>(lattice_places<1>(600), 600, 2.8);
  check_against_all_pairs<2>(lattice_places<2>(25), 625, 2.8);
  check_against_all_pairs<3>(lattice_places<3>(9), 729, 2.8);
}

TEST_CASE("Neighbours: those within the support come first, those of the skin behind them", "[neighbours]") {
  const auto places = random_places<2>(900, 20.0, 2);
  const auto all = listed<2>(places, 900, 1.3), parted = listed<2>(places, 900, {1.0, 1.3});
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    auto expected = row(all, i);
    std::erase(expected, i);
    std::ranges::stable_partition(expected, [&](auto j) {
      const auto x = places[i] - places[j];
      return dot(x, x) < 1.0;
    });
    auto found = row(parted, i);
    std::erase(found, i);
    REQUIRE(found == expected);
  }
}

TEST_CASE("Neighbours: a handful of particles within one cell find each other", "[neighbours]") {
  check_against_all_pairs<1>(random_places<1>(5, 0.5, 1), 5, 1.0);
  check_against_all_pairs<2>(random_places<2>(5, 0.5, 1), 5, 1.0);
  check_against_all_pairs<3>(random_places<3>(5, 0.5, 1), 5, 1.0);
}

TEST_CASE("Neighbours: far-flung fragments share cells but are no neighbours", "[neighbours]") {
  check_against_all_pairs<1>(with_fragments<1>(600), 600, 0.1);
  check_against_all_pairs<2>(with_fragments<2>(600), 600, 0.7);
  check_against_all_pairs<3>(with_fragments<3>(600), 600, 1.5);
}

TEST_CASE("Neighbours: a cell grid takes memory in proportion to the particles, wherever they fly", "[neighbours]") {
  CellGrid<3> grid;
  const auto places = with_fragments<3>(600);
  grid.build(places, 1.5);
  CHECK(grid.cells() <= 2 * places.size() + 256);
}

TEST_CASE("Neighbours: images of one and two symmetry planes are listed like particles", "[neighbours]") {
  const double reach = 1.3;
  const std::vector<std::vector<SymmetryPlane>> cases{{{0, 0.0, 1.0}}, {{0, 0.0, 1.0}, {1, 0.0, 1.0}}};
  for (const auto& planes : cases) {
    auto places = random_places<2>(500, 10.0, 4);
    places[0][0] = 0.0;  // on the plane: its image is in the same place
    const auto own = places;
    Mirror<2> mirror(planes);
    mirror.find(places, reach);
    REQUIRE(places.size() == own.size() + mirror.images());
    check_against_all_pairs<2>(places, own.size(), reach);

    // Every reflection that is within reach of a particle is there: the whole plane's worth of them, made by hand.
    std::size_t missing = 0;
    for (const double sx : {1.0, -1.0})
      for (const double sy : {1.0, -1.0}) {
        if (sx > 0.0 && sy > 0.0) continue;
        if (sy < 0.0 && planes.size() < 2) continue;
        for (const auto& x : own) {
          const Vector<double, 2> image{{sx * x[0], sy * x[1]}};
          const auto near = [&](const auto& y) {
            const auto r = y - image;
            return dot(r, r) < reach * reach;
          };
          if (std::ranges::none_of(own, near)) continue;
          const auto same = [&](const auto& y) { return y[0] == image[0] && y[1] == image[1]; };
          missing += std::none_of(places.begin() + static_cast<std::ptrdiff_t>(own.size()), places.end(), same);
        }
      }
    CHECK(missing == 0);
  }
}

TEST_CASE("Neighbours: the order does not depend on threads and does not change from build to build", "[neighbours]") {
  const auto places = random_places<3>(3000, 10.0, 5);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto alone = listed<3>(places, places.size(), 1.3);
  omp_set_num_threads(3);
  const auto together = listed<3>(places, places.size(), 1.3);
  omp_set_num_threads(threads);
  REQUIRE(alone.blocks().size() == together.blocks().size());
  for (std::size_t b = 0; b < alone.blocks().size(); ++b) {
    REQUIRE(alone.blocks()[b].first == together.blocks()[b].first);
    REQUIRE(alone.blocks()[b].neighbours == together.blocks()[b].neighbours);
  }
}

TEST_CASE("Neighbours: only the particles have rows, images have none", "[neighbours]") {
  const auto places = random_places<2>(300, 8.0, 6);
  const auto list = listed<2>(places, 200, 1.3);
  std::size_t rows = 0;
  for (const auto& block : list.blocks()) rows += block.first.size() - 1;
  CHECK(rows == 200);
}

TEST_CASE("Pair lists: members are those with neighbours and the neighbours, and runs without pairs go",
          "[pair_list]") {
  const auto places = random_places<2>(2000, 40.0, 7);
  auto list = listed<2>(places, places.size(), 1.3);
  const auto runs = list.blocks().size();
  REQUIRE(runs > 2);
  const auto wanted = [](std::uint32_t i, std::uint32_t j) { return i < 100 && j % 7 == 0; };
  std::set<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < places.size(); ++i)
    for (const auto j : row(list, i))
      if (j != i && wanted(i, j)) expected.insert({i, j});
  list.keep_pairs(wanted);
  list.drop_empty_runs();
  CHECK(list.blocks().size() < runs);
  const auto members = list.members(places.size(), [](std::uint32_t j) { return j; });
  CHECK(std::ranges::equal(members, expected));
  const auto part = members_in({100, 2000}, members);
  CHECK(std::ranges::equal(part, members | std::views::filter([](auto i) { return i >= 100; })));
}

TEST_CASE("Pair lists: within bodies and across bodies are the two parts of all", "[pair_list]") {
  Places<2> places;
  std::vector<std::uint32_t> body;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) {
      places.push_back({static_cast<double>(i), static_cast<double>(j)});
      body.push_back(i < 5 ? 0 : 1);
    }
  CellGrid<2> grid;
  const double reach = 2.5;
  grid.build(places, reach);
  PairList all, within, across;
  all.build<2>(grid, places, places.size(), reach, Pairing::all, body);
  within.build<2>(grid, places, places.size(), reach, Pairing::within_bodies, body);
  across.build<2>(grid, places, places.size(), reach, Pairing::across_bodies, body);
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::set<std::uint32_t> same, other, both;
    for (const auto j : row(within, i)) {
      CHECK(body[j] == body[i]);
      if (j != i) same.insert(j);
    }
    for (const auto j : row(across, i))
      if (j != i) {
        CHECK(body[j] != body[i]);
        other.insert(j);
      }
    for (const auto j : row(all, i))
      if (j != i) both.insert(j);
    CHECK(same.size() + other.size() == both.size());
  }
}
