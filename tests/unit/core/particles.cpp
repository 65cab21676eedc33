// The particles' arrays.
#include "core/particles.hpp"

#include <malloc.h>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "core/units.hpp"
#include "support/particles.hpp"

namespace tektite {
namespace {

TEST_CASE("Particles: the count is the end of the last body, and nothing is allocated unasked") {
  const Particles particles(Space::plane_strain, test::two_bodies());
  CHECK(particles.count() == 7);
  CHECK(particles.dimensions() == 2);
  CHECK(particles.memory() == 0);
  for (const auto& row : field_table) CHECK_FALSE(particles.has(row.field));
}

TEST_CASE("Particles: a field has the components that rank and space need") {
  const auto [space, vector, symmetric, tensor] = GENERATE(table<Space, int, int, int>({{Space::line, 1, 3, 1},
                                                                                        {Space::plane_strain, 2, 4, 4},
                                                                                        {Space::plane_stress, 2, 4, 4},
                                                                                        {Space::solid, 3, 6, 9}}));
  const Particles particles(space, test::two_bodies());
  CHECK(particles.components(Field::density) == 1);
  CHECK(particles.components(Field::id) == 1);
  CHECK(particles.components(Field::velocity) == vector);
  CHECK(particles.components(Field::deviatoric_stress) == symmetric);
  CHECK(particles.components(Field::velocity_gradient) == tensor);
}

TEST_CASE("Particles: numbers that are handed over are a field's, as many as belong there") {
  Particles particles(Space::plane_strain, test::two_bodies());
  particles.adopt(Field::velocity, std::vector<double>(7 * 2, 3.0));
  particles.adopt(Field::id, std::vector<std::int64_t>{7, 6, 5, 4, 3, 2, 1});
  CHECK(particles.vectors<2>(Field::velocity)[6][1] == 3.0);
  CHECK(particles.integers(Field::id)[6] == 1);
  CHECK_THROWS_WITH(particles.adopt(Field::velocity, std::vector<double>(7)),
                    "field velocity has 7 numbers where 14 belong");
  CHECK_THROWS_WITH(particles.adopt(Field::id, std::vector<std::int64_t>(8)), "field id has 8 numbers where 7 belong");
}

TEST_CASE("Particles: allocating fills with zeros, keeps what is there, and leaves room where asked") {
  Particles particles(Space::solid, test::two_bodies());
  particles.allocate(Field::velocity);
  REQUIRE(particles.reals(Field::velocity).size() == 7 * 3);
  for (const double value : particles.reals(Field::velocity)) CHECK(value == 0.0);
  particles.vectors<3>(Field::velocity)[6][2] = 5.0;
  particles.allocate(Field::velocity, 2);
  CHECK(particles.reals(Field::velocity).size() == 9 * 3);
  CHECK(particles.reals(Field::velocity)[6 * 3 + 2] == 5.0);
  CHECK(particles.memory() == 9 * 3 * sizeof(double));
  particles.release(Field::velocity);
  CHECK_FALSE(particles.has(Field::velocity));
}

TEST_CASE("Particles: a field that is released gives its memory back") {
  constexpr std::size_t count = 1'000'000;
  const auto in_use = [] { return ::mallinfo2().uordblks + ::mallinfo2().hblkhd; };
  Particles particles(Space::line, {{"bar", "steel", 1e-3, {0, count}}});
  for (const auto field : {Field::density, Field::id}) {
    particles.allocate(field);
    const auto before = in_use();
    particles.release(field);
    CHECK(in_use() + count * sizeof(double) <= before);
  }
}

TEST_CASE("Particles: asking for a field that is not there is an error of the program") {
  Particles particles(Space::line, test::two_bodies());
  CHECK_THROWS_WITH(particles.reals(Field::density), "field density is not allocated");
  CHECK_THROWS_WITH(particles.integers(Field::id), "field id is not allocated");
}

TEST_CASE("Particles: a permutation moves all numbers of a particle together, in every kept field and space") {
  const auto space = GENERATE(Space::line, Space::plane_strain, Space::plane_stress, Space::solid);
  auto particles = test::filled_particles(space);
  const auto before = particles;
  const std::vector<std::uint32_t> order{3, 0, 6, 5, 1, 2, 4};
  particles.permute(order);
  for (const auto& row : field_table) {
    if (!saved(row.keep)) continue;
    const auto width = static_cast<std::size_t>(particles.components(row.field));
    INFO(row.name);
    for (std::size_t k = 0; k < order.size(); ++k)
      for (std::size_t c = 0; c < width; ++c) {
        if (row.rank == Rank::integer)
          CHECK(particles.integers(row.field)[k * width + c] == before.integers(row.field)[order[k] * width + c]);
        else
          CHECK(particles.reals(row.field)[k * width + c] == before.reals(row.field)[order[k] * width + c]);
      }
  }
}

TEST_CASE("Fields: names are unique and lead back to their row") {
  for (const auto& row : field_table) {
    CHECK(field_named(row.name) == row.field);
    CHECK(info(row.field).name == row.name);
  }
  CHECK_FALSE(field_named("colour"));
}

TEST_CASE("Fields: every unit in the table is one that scenes know") {
  for (const auto& row : field_table) {
    INFO(row.name << " in " << row.unit);
    const auto quantity = parse_quantity("1 " + std::string(row.unit));
    REQUIRE(quantity);
    CHECK(quantity->value == 1.0);
  }
}

}  // namespace
}  // namespace tektite
