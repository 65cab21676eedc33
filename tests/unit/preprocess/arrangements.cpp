#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "scene_text.hpp"
#include "support/fault.hpp"

using namespace tektite;
using namespace tektite::test;

TEST_CASE("Lattice with rings: the published disc has 7830 particles") {
  const std::string disc = "{ type = 'disc', centre = ['-0.5 cm', 0], radius = '0.5 cm' }";
  CHECK(count_of(disc, "{ type = 'lattice-with-rings', rings = 2 }", 2, 1e-4) == 7830);
  // 2π·49 = 307.88: rounded to nearest, the inner ring has one more
  CHECK(count_of(disc, "{ type = 'lattice-with-rings', rings = 2, inner_rounding = 'nearest' }", 2, 1e-4) == 7831);
}

TEST_CASE("Rings: the count is the sum of rounded circumferences, 8012 for the published disc") {
  const std::string disc = "{ type = 'disc', radius = '0.5 cm' }";
  CHECK(count_of(disc, "{ type = 'rings' }", 2, 1e-4) == 8012);
  std::size_t down = 1, centred = 0;
  for (int k = 1; k <= 50; ++k) down += static_cast<std::size_t>(std::floor(2.0 * M_PI * k));
  for (int k = 0; k < 50; ++k) centred += static_cast<std::size_t>(std::llround(2.0 * M_PI * (k + 0.5)));
  CHECK(count_of(disc, "{ type = 'rings', rounding = 'down' }", 2, 1e-4) == down);
  CHECK(count_of(disc, "{ type = 'rings', radii = 'cell-centred' }", 2, 1e-4) == centred);
}

TEST_CASE("Rings: a ring is filled from its inner to its outer edge") {
  std::size_t expected = 0;
  for (int k = 10; k <= 20; ++k) expected += static_cast<std::size_t>(std::llround(2.0 * M_PI * k));
  CHECK(count_of("{ type = 'ring', inner_radius = 1.0, outer_radius = 2.0 }", "{ type = 'rings' }", 2, 0.1) ==
        expected);
}

TEST_CASE("Lattice: a cell-centred plate has as many particles as cells") {
  const std::string target = "{ type = 'rectangle', lower = [0, '-2.505 cm'], upper = ['0.2 cm', '2.505 cm'] }";
  CHECK(count_of(target, "{ type = 'lattice' }", 2, 1e-4) == 10020);
  const std::string plate = "{ type = 'box', lower = [0, 0, 0], upper = ['3 mm', '100 mm', '100 mm'] }";
  CHECK(count_of(plate, "{ type = 'lattice', convention = 'cell-centred' }", 3, 1e-3) == 30000);
  CHECK(count_of("{ type = 'segment', lower = -0.3, upper = 0.4 }", "{ type = 'lattice' }", 1, 0.1) == 7);
}

TEST_CASE("Lattice: half a spacing off the centre, the published sphere has 912 particles") {
  for (const std::string centre : {"[0, 0, 0]", "['-6 mm', '1.3 m', '7.7 mm']"})
    CHECK(count_of("{ type = 'sphere', centre = " + centre + ", radius = '6 mm' }",
                   "{ type = 'lattice', convention = 'half-off-origin' }", 3, 1e-3) == 912);
}

TEST_CASE("Lattice: with a particle on the origin, points exactly on a sphere's edge are kept") {
  std::size_t expected = 0;
  for (int i = -6; i <= 6; ++i)
    for (int j = -6; j <= 6; ++j)
      for (int k = -6; k <= 6; ++k) expected += i * i + j * j + k * k <= 36;  // (6,0,0), (4,4,2) lie on the edge
  CHECK(count_of("{ type = 'sphere', centre = ['0.1 mm', '0.7 m', '-3 mm'], radius = '6 mm' }",
                 "{ type = 'lattice', convention = 'on-origin' }", 3, 1e-3) == expected);
}

TEST_CASE("Lattice: with both edges included, the published counts come out") {
  const std::string edges = "{ type = 'lattice', convention = 'edges-included' }";
  const std::string steel = "{ type = 'rectangle', lower = [0, 0], upper = ['20 mm', '10 mm'] }";
  const std::string ceramic = "{ type = 'rectangle', lower = [0, 0], upper = ['100 mm', '30 mm'] }";
  CHECK(count_of(steel, edges, 2, 0.25e-3) + count_of(ceramic, edges, 2, 0.25e-3) == 51842);
  const std::string bar = "{ type = 'rectangle', lower = [0, 0], upper = ['3.7975 mm', '37.975 mm'] }";
  CHECK(count_of(bar, edges, 2, 3.7975e-3 / 19) == 3820);
}

TEST_CASE("Lattice: with both edges included, the spacing is stretched to reach them and the cell with it") {
  const auto shape = shape_of("{ type = 'rectangle', lower = [0, 0], upper = [1.04, 0.5] }", 2);
  const auto filling =
      arrangement_of("{ type = 'lattice', convention = 'edges-included' }", 2).arrangement->fill(*shape, 0.1, {});
  REQUIRE(filling.positions.size() == 11 * 6);
  CHECK(filling.positions.back()[0] == Approx(1.04).epsilon(1e-14));
  CHECK(filling.cell == Approx(0.104 * 0.1).epsilon(1e-14));
}

namespace {

bool same(const preprocess::Point& a, const preprocess::Point& b) { return std::ranges::equal(a.c, b.c); }

}  // namespace

TEST_CASE("Arrangements: shares, however many, follow each other as the places of the whole, to the last bit") {
  const std::string disc = "{ type = 'disc', centre = [0.3, 0.1], radius = 0.97 }";
  const std::string ball = "{ type = 'sphere', centre = [1, 2, 3], radius = 0.77 }";
  const auto [shape, arrangement, dimensions] = GENERATE_COPY(table<std::string, std::string, int>(
      {{disc, "{ type = 'lattice' }", 2},
       {disc, "{ type = 'hexagonal' }", 2},
       {disc, "{ type = 'rings', radii = 'cell-centred' }", 2},
       {disc, "{ type = 'lattice-with-rings', start_angle = 0.1 }", 2},
       {ball, "{ type = 'lattice', convention = 'on-origin' }", 3},
       {ball, "{ type = 'close-packed', stacking = 'hcp' }", 3},
       {ball, "{ type = 'shells' }", 3},
       {"{ type = 'segment', lower = 0.0, upper = 0.7 }", "{ type = 'lattice' }", 1}}));
  INFO(arrangement);
  const auto filled = shape_of(shape, dimensions);
  const auto choice = arrangement_of(arrangement, dimensions);
  const auto whole = choice.arrangement->fill(*filled, 0.1, {});
  for (const std::size_t parts : {2, 3, 7, 1000}) {
    std::vector<preprocess::Point> joined;
    for (std::size_t part = 0; part < parts; ++part) {
      const auto filling = choice.arrangement->fill(*filled, 0.1, {part, parts});
      CHECK(filling.cell == whole.cell);
      joined.insert(joined.end(), filling.positions.begin(), filling.positions.end());
    }
    CHECK(std::ranges::equal(joined, whole.positions, same));
  }
}

TEST_CASE("Shares: they follow each other, cover all, and differ by one at most") {
  for (const std::size_t count : {std::size_t{0}, std::size_t{5}, std::size_t{1000}, std::size_t{1} << 60})
    for (const std::size_t parts : {1, 2, 3, 7, 10'000}) {
      std::size_t end = 0, least = count, most = 0;
      for (std::size_t part = 0; part < parts; ++part) {
        const auto range = preprocess::Share{part, parts}.of(count);
        REQUIRE(range.begin == end);
        end = range.end;
        least = std::min(least, range.size());
        most = std::max(most, range.size());
      }
      CHECK(end == count);
      CHECK(most - least <= 1);
    }
}

TEST_CASE("Shells: the count is the sum of rounded areas, and every particle lies on its shell") {
  std::size_t expected = 1;
  for (int k = 1; k <= 8; ++k) expected += static_cast<std::size_t>(std::llround(4.0 * M_PI * k * k));
  const auto shape = shape_of("{ type = 'sphere', centre = [1, 2, 3], radius = 0.8 }", 3);
  const auto filling = arrangement_of("{ type = 'shells' }", 3).arrangement->fill(*shape, 0.1, {});
  CHECK(filling.positions.size() == expected);
  for (const auto& p : filling.positions) {
    const double shell = norm(p - preprocess::Point{{1, 2, 3}}) / 0.1;
    CHECK(std::abs(shell - std::round(shell)) < 1e-12);  // rounding of a few operations
  }
}

namespace {

std::pair<double, std::size_t> nearest_and_its_count(const std::vector<preprocess::Point>& positions, std::size_t of) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < positions.size(); ++k)
    if (k != of) nearest = std::min(nearest, norm(positions[k] - positions[of]));
  std::size_t count = 0;
  for (std::size_t k = 0; k < positions.size(); ++k)
    count += k != of && norm(positions[k] - positions[of]) < nearest * (1.0 + 1e-9);
  return {nearest, count};
}

std::size_t index_at(const std::vector<preprocess::Point>& positions, const preprocess::Point& place) {
  for (std::size_t k = 0; k < positions.size(); ++k)
    if (norm(positions[k] - place) < 1e-12) return k;
  FAIL("no particle at the origin");
  return 0;
}

}  // namespace

TEST_CASE("Hexagonal and close-packed: six and twelve neighbours at one spacing, and the density of their cells") {
  const auto plane = shape_of("{ type = 'disc', centre = [0.3, 0.2], radius = 1.0 }", 2);
  const auto hexagonal = arrangement_of("{ type = 'hexagonal' }", 2).arrangement->fill(*plane, 0.05, {});
  const auto centre = index_at(hexagonal.positions, {{0.3, 0.2, 0}});
  const auto [distance, neighbours] = nearest_and_its_count(hexagonal.positions, centre);
  CHECK(distance == Approx(0.05).epsilon(1e-12));
  CHECK(neighbours == 6);
  // Gauss's circle problem: the count differs from area / cell by less than the cells along the edge.
  CHECK(static_cast<double>(hexagonal.positions.size()) * hexagonal.cell == Approx(M_PI).epsilon(0.02));

  const auto solid = shape_of("{ type = 'sphere', centre = [0, 0, 1], radius = 1.0 }", 3);
  for (const std::string stacking : {"fcc", "hcp"}) {
    const auto packed = arrangement_of("{ type = 'close-packed', stacking = '" + stacking + "' }", 3)
                            .arrangement->fill(*solid, 0.1, {});
    const auto middle = index_at(packed.positions, {{0, 0, 1}});
    const auto [gap, twelve] = nearest_and_its_count(packed.positions, middle);
    CHECK(gap == Approx(0.1).epsilon(1e-12));
    CHECK(twelve == 12);
    CHECK(static_cast<double>(packed.positions.size()) * packed.cell == Approx(4.0 / 3.0 * M_PI).epsilon(0.02));
  }
}

TEST_CASE("A wished count is met to within the layer by which counts jump, for every arrangement") {
  struct Case {
    std::string shape, arrangement;
    int dimensions;
  };
  const std::string disc = "{ type = 'disc', radius = 1.0 }", ball = "{ type = 'sphere', radius = 1.0 }";
  const auto [shape, arrangement, dimensions] =
      GENERATE_COPY(Case{disc, "{ type = 'lattice', convention = 'on-origin' }", 2},
                    Case{disc, "{ type = 'rings' }", 2}, Case{disc, "{ type = 'lattice-with-rings' }", 2},
                    Case{disc, "{ type = 'hexagonal' }", 2}, Case{ball, "{ type = 'lattice' }", 3},
                    Case{ball, "{ type = 'shells' }", 3}, Case{ball, "{ type = 'close-packed' }", 3},
                    Case{"{ type = 'segment', lower = 0, upper = 1 }", "{ type = 'lattice' }", 1});
  const auto body = shape_of(shape, dimensions);
  const auto choice = arrangement_of(arrangement, dimensions);
  constexpr std::size_t wished = 3000;
  const double spacing = preprocess::spacing_for_count(*choice.arrangement, *body, wished);
  const auto count = static_cast<double>(choice.arrangement->count(*body, spacing));
  // One more layer changes 3000 particles by 2·3000^(1/2) in the plane and by 3·3000^(2/3) in solids; half of it can be
  // missed.
  CHECK(std::abs(count - wished) <= 0.5 * dimensions * std::pow(wished, 1.0 - 1.0 / dimensions) + 1.0);
}

TEST_CASE("Rings: the published counts of the collapsing ring are met to within half a ring of particles") {
  const auto ring = shape_of("{ type = 'ring', inner_radius = '80 mm', outer_radius = '100 mm' }", 2);
  const auto rings = arrangement_of("{ type = 'rings' }", 2);
  for (const std::size_t wished : {8012u, 23506u}) {
    const double spacing = preprocess::spacing_for_count(*rings.arrangement, *ring, wished);
    const auto count = static_cast<double>(rings.arrangement->count(*ring, spacing));
    CHECK(std::abs(count - static_cast<double>(wished)) <= M_PI * 0.1 / spacing);  // counts jump by one ring
  }
}

TEST_CASE("Arrangements: unknown names and those of another space are answered with what is allowed") {
  CHECK_THAT(fault_of([] { arrangement_of("{ type = 'latice' }", 2); }),
             Catch::Contains("lattice, rings, lattice-with-rings, hexagonal"));
  CHECK_THAT(fault_of([] { arrangement_of("{ type = 'rings' }", 3); }),
             Catch::Contains("lattice, shells, close-packed"));
  CHECK_THAT(fault_of([] { arrangement_of("{ type = 'lattice', convention = 'centred' }", 2); }),
             Catch::Contains("cell-centred, on-origin, half-off-origin, edges-included"));
  CHECK_THAT(fault_of([] { arrangement_of("{ type = 'rings', convention = 'on-origin' }", 2); }),
             Catch::Contains("unknown key"));
}
