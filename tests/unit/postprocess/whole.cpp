// Symmetry planes: the whole that half a model stands for.

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "core/kernel_type.hpp"
#include "postprocess/scalar_field.hpp"
#include "postprocess/whole.hpp"
#include "support/particles.hpp"
#include "support/temporary_folder.hpp"
#include "unit/postprocess/synthetic.hpp"

namespace tektite::test {

TEST_CASE("Whole: an image lies on the other side of its plane and moves as mirrored") {
  const auto snapshot = snapshot_of(Space::plane_strain, {{"a", {1.0, 2.0, 0}, {3.0, 4.0, 0}}}, 0.5, "", as_it_is);
  const auto whole = make_whole(snapshot, {{1, 0.5, 1.0}});
  REQUIRE(whole.count() == 2);
  CHECK(whole.time == 0.5);
  CHECK(whole.position[1][0] == 1.0);
  CHECK(whole.position[1][1] == -1.0);
  CHECK(whole.velocity[1][0] == 3.0);
  CHECK(whole.velocity[1][1] == -4.0);
  CHECK(whole.source[1] == 0);
}

TEST_CASE("Whole: two planes make four quarters, three make eight octants") {
  const auto snapshot = snapshot_of(Space::solid, {{"a", {1.0, 2.0, 3.0}, {0, 0, 0}}}, 0.0, "", as_it_is);
  CHECK(make_whole(snapshot, {{0, 0.0, 1.0}, {1, 0.0, 1.0}}).count() == 4);
  const auto whole = make_whole(snapshot, {{0, 0.0, 1.0}, {1, 0.0, 1.0}, {2, 0.0, 1.0}});
  REQUIRE(whole.count() == 8);
  CHECK(whole.position[7][0] == -1.0);
  CHECK(whole.position[7][1] == -2.0);
  CHECK(whole.position[7][2] == -3.0);
}

TEST_CASE("Whole: read from a file, field by field, it is that of the snapshot, and takes no other fields") {
  const TemporaryFolder folder;
  const auto space = GENERATE(Space::line, Space::axisymmetric, Space::solid);
  Snapshot snapshot{filled_particles(space), {{"time", 1e-6}}, ""};
  const auto damage = snapshot.particles.reals(Field::damage);
  std::ranges::fill(damage, 0.5);
  damage[1] = damage[5] = 1.0;
  for (auto& type : snapshot.particles.integers(Field::kernel_type))
    type = static_cast<std::int64_t>(KernelType::total_lagrangian);
  snapshot.particles.integers(Field::kernel_type)[5] = static_cast<std::int64_t>(KernelType::eulerian);
  if (const bool tells = GENERATE(true, false); !tells) snapshot.particles.release(Field::kernel_type);
  write_snapshot(snapshot, folder.file("particles.h5"));
  const std::vector<SymmetryPlane> planes{{0, 0.0, 1.0}};
  const auto read = read_whole(folder.file("particles.h5"), planes);
  for (const auto& row : field_table)
    if (!fields_of_whole().contains(row.field)) snapshot.particles.release(row.field);
  const auto made = make_whole(snapshot, planes);
  REQUIRE(made.count() == 14);
  CHECK(read.time == made.time);
  CHECK(read.axis_image == made.axis_image);
  const auto same_points = [](const auto& a, const auto& b) {
    return std::ranges::equal(a, b, [](const Point& p, const Point& q) { return norm(p - q) == 0.0; });
  };
  CHECK(same_points(read.position, made.position));
  CHECK(same_points(read.velocity, made.velocity));
  CHECK(read.mass == made.mass);
  CHECK(read.smoothing_length == made.smoothing_length);
  CHECK(read.body == made.body);
  CHECK(read.id == made.id);
  CHECK(read.source == made.source);
  CHECK(read.image == made.image);
  CHECK(read.severed == made.severed);
  CHECK(std::ranges::count(made.severed, 1) == (snapshot.particles.has(Field::kernel_type) ? 2 : 0));
}

TEST_CASE("Scalar field: what it is said to need is all that it needs") {
  const auto space = GENERATE(Space::line, Space::plane_strain, Space::solid);
  const Snapshot all{filled_particles(space), {{"time", 0.0}}, ""};
  for (const auto& name : scalar_field_names()) {
    INFO(name);
    auto some = all;
    for (const auto& row : field_table)
      if (!scalar_field_needs(name).contains(row.field)) some.particles.release(row.field);
    CHECK(scalar_field(some, name) == scalar_field(all, name));
  }
}

TEST_CASE("Whole: what is odd across a plane turns its sign in the image, and back in the image of that") {
  const auto snapshot = snapshot_of(Space::solid, {{"a", {1.0, 2.0, 3.0}, {0, 0, 0}}}, 0.0, "", as_it_is);
  const std::vector<SymmetryPlane> planes{{1, 0.0, 1.0}, {0, 0.0, 1.0}};
  const auto whole = make_whole(snapshot, planes);
  const auto seen = [&](const std::string& field) { return with_images({5.0}, field, whole, planes); };
  CHECK(seen("velocity_y") == std::vector<double>{5.0, -5.0, 5.0, -5.0});
  CHECK(seen("velocity_x") == std::vector<double>{5.0, 5.0, -5.0, -5.0});
  CHECK(seen("stress_xy") == std::vector<double>{5.0, -5.0, -5.0, 5.0});
  for (const auto* even : {"velocity_z", "stress_xx", "stress_yy", "pressure", "speed", "body"})
    CHECK(seen(even) == std::vector<double>(4, 5.0));
}

TEST_CASE("Whole: particles are found again by id and image after they were ordered anew") {
  const auto first = snapshot_of(Space::line, {{"a", {1.0, 0, 0}, {}}, {"a", {2.0, 0, 0}, {}}}, 0.0, "", as_it_is);
  auto later = first;
  const std::vector<std::uint32_t> order{1, 0};
  later.particles.permute(order);
  const std::vector<SymmetryPlane> planes{{0, 0.0, 1.0}};
  CHECK(places_in(make_whole(first, planes), make_whole(later, planes)) == std::vector<std::uint32_t>{1, 0, 3, 2});
  later.particles.integers(Field::id)[0] = 77;
  CHECK_THROWS_WITH(places_in(make_whole(first, planes), make_whole(later, planes)),
                    "particle 77 of the last snapshot is not in the first one");
}

TEST_CASE("Whole: a body that is not there is answered with those that are") {
  const auto whole =
      make_whole(snapshot_of(Space::line, {{"a", {1.0, 0, 0}, {}}, {"b", {2.0, 0, 0}, {}}}, 0.0, "", as_it_is), {});
  CHECK_THROWS_WITH(whole.body_named("c"), Catch::Contains("no body c") && Catch::Contains("a, b"));
}

}  // namespace tektite::test
