// What several ranks need so that they come to the same bits as one: sums and orders that do not depend on how the
// particles are grouped.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "neighbours/order.hpp"
#include "parallel/packed.hpp"
#include "parallel/sums.hpp"
#include "support/particles.hpp"

using namespace tektite;

namespace {

std::vector<double> numbers_of_many_sizes(std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> sign(-1.0, 1.0), exponent(-30.0, 3.0);
  std::vector<double> numbers(count);
  for (auto& number : numbers) number = sign(random) * std::pow(10.0, exponent(random));
  return numbers;
}

double sum_of(const std::vector<double>& numbers) {
  Particles particles(Space::line, {{"all", "metal", 1.0, {0, numbers.size()}}});
  return sum_over<1>(particles, [&](std::size_t i) { return std::array{numbers[i]}; })[0];
}

}  // namespace

TEST_CASE("Sums: their bits do not depend on the order, and they are right to the round-off of the largest term") {
  auto numbers = numbers_of_many_sizes(20000);
  long double exact = 0.0L;
  for (const double number : numbers) exact += number;
  const double sum = sum_of(numbers);
  CHECK(std::abs(sum - static_cast<double>(exact)) < 1e-12);
  std::mt19937 random(11);
  bool plain_differs = false;
  const double plain = std::accumulate(numbers.begin(), numbers.end(), 0.0);
  for (int k = 0; k < 20; ++k) {
    std::ranges::shuffle(numbers, random);
    CHECK(sum_of(numbers) == sum);
    plain_differs = plain_differs || std::accumulate(numbers.begin(), numbers.end(), 0.0) != plain;
  }
  CHECK(plain_differs);
}

TEST_CASE("Sums: nothing, infinite and missing numbers come out as what they are") {
  CHECK(sum_of({0.0, 0.0}) == 0.0);
  CHECK(sum_of({1e300, -1e300, 1.0}) == 0.0);  // next to the largest term
  CHECK(sum_of({1e-310, 1e-310}) == 2e-310);
  CHECK_FALSE(std::isfinite(sum_of({1.0, std::numeric_limits<double>::infinity()})));
  CHECK(std::isnan(sum_of({1.0, std::numeric_limits<double>::quiet_NaN()})));
}

TEST_CASE("Sums: one that is taken again has the bits of one that is taken anew, whatever came before") {
  RepeatedSum<1> again;
  // Larger, smaller, none, what is not finite, ordinary ones again.
  for (const double scale : {1.0, 1.0, 1e6, 1e-9, 0.0, 3.0, std::numeric_limits<double>::infinity(), 1.0, 1.0}) {
    auto numbers = numbers_of_many_sizes(1001);
    for (auto& number : numbers) number *= scale;
    const Particles particles(Space::line, {{"all", "metal", 1.0, {0, numbers.size()}}});
    const auto sum = again(particles, [&](std::size_t i) { return std::array{numbers[i]}; })[0];
    CAPTURE(scale);
    if (std::isfinite(scale))
      CHECK(sum == sum_of(numbers));
    else
      CHECK_FALSE(std::isfinite(sum));
  }
}

TEST_CASE("Order: particles stand by cells and ids, whatever their order was before") {
  auto particles = test::filled_particles(Space::plane_strain);
  auto turned = particles;
  std::vector<std::uint32_t> order;
  for (const auto& body : particles.bodies())
    for (std::size_t i = body.range.end; i > body.range.begin; --i) order.push_back(static_cast<std::uint32_t>(i - 1));
  turned.permute(order);
  REQUIRE_FALSE(std::ranges::equal(particles.integers(Field::id), turned.integers(Field::id)));
  for (const double side : {1e-3, 1e3}) {
    order_in_space<2>(particles, side);
    order_in_space<2>(turned, side);
    CHECK(std::ranges::equal(particles.integers(Field::id), turned.integers(Field::id)));
  }
}

TEST_CASE("Packed particles: members and records in any order stand in the order of bodies, sequence and ids") {
  auto particles = test::filled_particles(Space::solid);
  particles.allocate(Field::sequence);
  particles.allocate(Field::owner);
  const auto sequence = particles.integers(Field::sequence);
  std::iota(sequence.begin(), sequence.end(), std::int64_t{0});
  const PackedLayout layout(particles);
  Words words;
  layout.pack(particles, std::vector<std::uint32_t>{3, 6, 1, 4}, words);
  const std::vector<std::uint32_t> members{5, 0, 2};
  auto built = layout.joined(particles, members, words);
  if (GENERATE(false, true)) {
    built = particles;
    built.allocate(Field::half_pressure);  // which no record has
    layout.join(built, members, words);
    CHECK_FALSE(built.has(Field::half_pressure));
  }
  REQUIRE(built.bodies().size() == particles.bodies().size());
  for (std::size_t k = 0; k < built.bodies().size(); ++k) {
    CHECK(built.bodies()[k].range.begin == particles.bodies()[k].range.begin);
    CHECK(built.bodies()[k].range.end == particles.bodies()[k].range.end);
  }
  for (const auto& row : field_table) {
    if (!particles.has(row.field) || row.keep == Keep::scratch) continue;
    INFO(row.name);
    if (row.rank == Rank::integer)
      CHECK(std::ranges::equal(built.integers(row.field), particles.integers(row.field)));
    else
      CHECK(std::ranges::equal(built.reals(row.field), particles.reals(row.field)));
  }
}
