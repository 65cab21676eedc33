// The particle file: what is written comes back, and what is broken is refused.
#include "core/snapshot.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/hdf5.hpp"
#include "support/fault.hpp"
#include "support/particles.hpp"
#include "support/temporary_folder.hpp"
#include "support/unfinished_file.hpp"

namespace tektite {
namespace {

using Catch::Matchers::Contains;
using test::fault_of;

Snapshot sample(Space space = Space::plane_strain) {
  return {test::filled_particles(space), {{"time", 1.25e-6}, {"step", 42.0}, {"odd", 0.1}}, "name = \"sample\"\n"};
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_bytes(const std::string& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

/// Names of the kept fields that one of the two has and the other has not, or has with other numbers.
std::vector<std::string> fields_that_differ(const Particles& a, const Particles& b) {
  std::vector<std::string> names;
  for (const auto& row : field_table) {
    if (!saved(row.keep)) continue;
    bool same = a.has(row.field) && b.has(row.field);
    if (same && row.rank == Rank::integer)
      same = std::ranges::equal(a.integers(row.field), b.integers(row.field));
    else if (same)
      same = std::ranges::equal(a.reals(row.field), b.reals(row.field));
    if (!same) names.emplace_back(row.name);
  }
  return names;
}

bool same_bodies(const std::vector<Body>& a, const std::vector<Body>& b) {
  return std::ranges::equal(a, b, [](const Body& left, const Body& right) {
    return left.name == right.name && left.material == right.material && left.spacing == right.spacing &&
           left.range.begin == right.range.begin && left.range.end == right.range.end;
  });
}

/// A sample in a folder of its own.
struct Written {
  explicit Written(const Snapshot& snapshot = sample()) { write_snapshot(snapshot, path); }
  test::TemporaryFolder folder;
  std::string path = folder.file("particles.h5");
};

TEST_CASE("Snapshot: what several read of the rows is together what one reads") {
  for (const auto space : {Space::line, Space::solid}) {
    const Written written(sample(space));
    const auto whole = read_snapshot(written.path);
    const auto positions = whole.particles.reals(Field::position);
    const auto ids = whole.particles.integers(Field::id);
    const auto columns = static_cast<std::size_t>(whole.particles.dimensions());
    std::vector<std::size_t> left(2, 0);
    for (const auto& [first, count] : {std::pair{0, 2}, {2, 3}, {5, 0}, {5, 2}}) {
      const auto from = static_cast<std::size_t>(first), size = static_cast<std::size_t>(count);
      const auto part = read_rows(written.path, [=](std::size_t all) { return hdf5::Rows(from, size, all); });
      REQUIRE(part.particles.count() == size);
      CHECK(part.state == whole.state);
      CHECK(
          std::ranges::equal(part.particles.reals(Field::position), positions.subspan(from * columns, size * columns)));
      CHECK(std::ranges::equal(part.particles.integers(Field::id), ids.subspan(from, size)));
      for (std::size_t k = 0; k < 2; ++k) left[k] += part.particles.bodies()[k].range.size();
    }
    CHECK(left == std::vector<std::size_t>{3, 4});
  }
}

TEST_CASE("Snapshot: of the fields those are read that are wanted and there, of all rows or of some") {
  auto snapshot = sample(Space::solid);
  snapshot.particles.release(Field::damage);
  const Written written(snapshot);
  const FieldSet wanted{Field::id, Field::deviatoric_stress, Field::damage};
  const auto stress = snapshot.particles.reals(Field::deviatoric_stress);
  const auto ids = snapshot.particles.integers(Field::id);
  const auto whole = read_fields(written.path, wanted);
  const auto part = read_rows(
      written.path, [](std::size_t all) { return hdf5::Rows(2, 3, all); }, wanted);
  for (const auto& row : field_table) {
    INFO(row.name);
    const bool there = row.field == Field::id || row.field == Field::deviatoric_stress;
    CHECK(whole.particles.has(row.field) == there);
    CHECK(part.particles.has(row.field) == there);
  }
  CHECK(std::ranges::equal(whole.particles.reals(Field::deviatoric_stress), stress));
  CHECK(std::ranges::equal(part.particles.reals(Field::deviatoric_stress), stress.subspan(2 * 6, 3 * 6)));
  CHECK(std::ranges::equal(part.particles.integers(Field::id), ids.subspan(2, 3)));

  auto held = saved_fields();
  held.erase(Field::damage);
  CHECK(fields_in(written.path) == held);

  const auto beside = read_fields(written.path, {});
  CHECK(beside.particles.memory() == 0);
  CHECK(beside.particles.count() == 7);
  CHECK(same_bodies(beside.particles.bodies(), test::two_bodies()));
  CHECK(beside.scene == snapshot.scene);
  CHECK(beside.state == snapshot.state);
}

TEST_CASE("Snapshot: a field that every file has is missed where it is not wanted, too") {
  auto snapshot = sample();
  snapshot.particles.release(Field::mass);
  const Written written(snapshot);
  CHECK_THAT(fault_of([&] { read_fields(written.path, {Field::id}); }), Contains("/particles/mass: is missing"));
}

TEST_CASE("Snapshot: every kept field, in every space, comes back bit for bit") {
  const auto space = GENERATE(Space::line, Space::plane_strain, Space::plane_stress, Space::solid);
  const auto written = sample(space);
  const Written file(written);
  const auto read = read_snapshot(file.path);
  CHECK(read.scene == written.scene);
  CHECK(read.state == written.state);
  CHECK(read.particles.space() == space);
  CHECK(fields_that_differ(read.particles, written.particles).empty());
}

TEST_CASE("Snapshot: bodies come back with name, material, spacing and range") {
  const Written file;
  CHECK(same_bodies(read_snapshot(file.path).particles.bodies(), test::two_bodies()));
}

TEST_CASE("Snapshot: spare places of a field are not written") {
  auto snapshot = sample();
  snapshot.particles.allocate(Field::density, 5);
  for (auto& value : snapshot.particles.reals(Field::density)) value = 1.0;
  const Written file(snapshot);
  CHECK(read_snapshot(file.path).particles.reals(Field::density).size() == 7);
}

TEST_CASE("Snapshot: what is missing, foreign or no HDF5 is refused") {
  const test::TemporaryFolder folder;
  CHECK_THAT(fault_of([&] { read_snapshot(folder.file("none.h5")); }), Contains("none.h5: there is no such file"));
  CHECK_THAT(fault_of([&] { read_snapshot(folder.path()); }), Contains("this is no file"));
  write_bytes(folder.file("empty.h5"), "");
  CHECK_THAT(fault_of([&] { read_snapshot(folder.file("empty.h5")); }), Contains("cannot be opened as HDF5"));
  write_bytes(folder.file("text.h5"), "name = \"a scene\"\n");
  CHECK_THAT(fault_of([&] { read_snapshot(folder.file("text.h5")); }), Contains("cannot be opened as HDF5"));
  {
    hdf5::Writer foreign(folder.file("foreign.h5"));
    foreign.text("/note", "from elsewhere");
    foreign.close();
  }
  CHECK_THAT(fault_of([&] { read_snapshot(folder.file("foreign.h5")); }), Contains("/@format: is missing"));
  {
    hdf5::Writer other(folder.file("other.h5"));
    other.attribute("/", "format", std::string("tektite chart"));
    other.close();
  }
  CHECK_THAT(fault_of([&] { read_snapshot(folder.file("other.h5")); }),
             Contains("other.h5: /@format: this is no particle file (allowed: a particle file of tektite, whole)"));
}

TEST_CASE("Snapshot: a file of a newer format is refused with both versions") {
  const test::TemporaryFolder folder;
  hdf5::Writer newer(folder.file("newer.h5"));
  newer.attribute("/", "format", std::string("tektite particles"));
  newer.attribute("/", "format_version", std::int64_t{particle_format_version + 1});
  newer.close();
  CHECK_THAT(fault_of([&] { read_snapshot(folder.file("newer.h5")); }),
             Contains("format " + std::to_string(particle_format_version + 1) + " is not known") &&
                 Contains("up to " + std::to_string(particle_format_version)));
}

TEST_CASE("Snapshot: a truncated file is refused, wherever it ends") {
  const Written file;
  const auto whole = bytes_of(file.path);
  const auto cut = file.folder.file("cut.h5");
  for (std::size_t length = 0; length < whole.size(); length += 1 + whole.size() / 97) {
    INFO(length << " of " << whole.size() << " bytes");
    write_bytes(cut, whole.substr(0, length));
    CHECK_THROWS_AS(read_snapshot(cut), InputError);
  }
}

TEST_CASE("Snapshot: a flipped bit is refused, wherever it is") {
  const Written file;
  const auto whole = bytes_of(file.path);
  const auto flipped = file.folder.file("flipped.h5");
  constexpr std::size_t stride = 53;  // prime, so that every kind of byte in the file's structures is hit
  constexpr std::size_t seal = 16;    // without its mark the file is a plain HDF5 file, and whole
  for (std::size_t at = 0; at < whole.size() - seal; at += stride) {
    auto bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << (at % 8)));
    write_bytes(flipped, bytes);
    INFO("byte " << at << " of " << whole.size());
    CHECK_THROWS_WITH(read_snapshot(flipped), Contains("its checksum is wrong"));
  }
}

/// Puts another value in the place of an attribute.
void replace(const std::string& path, const char* object, const char* name, hid_t type, const void* value) {
  const hdf5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  REQUIRE(H5Adelete_by_name(file.id(), object, name, H5P_DEFAULT) >= 0);
  const hdf5::Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const hdf5::Handle attribute(
      H5Acreate_by_name(file.id(), object, name, type, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  REQUIRE(H5Awrite(attribute.id(), type, value) >= 0);
}

TEST_CASE("Snapshot: a file whose seal is cut off or no seal any more is refused, and one of format 1 needs none") {
  const Written file;
  const auto whole = bytes_of(file.path);
  constexpr std::size_t seal = 16;
  const auto says = "its end is missing, which has the checksum of the rest";
  write_bytes(file.path, whole.substr(0, whole.size() - seal));
  CHECK_THAT(fault_of([&] { read_snapshot(file.path); }), Contains(file.path) && Contains(says));
  auto bytes = whole;
  bytes[whole.size() - seal] ^= 1;
  write_bytes(file.path, bytes);
  CHECK_THAT(fault_of([&] { read_snapshot(file.path); }), Contains(says));

  write_bytes(file.path, whole);
  const std::int64_t first_format = 1;
  replace(file.path, "/", "format_version", H5T_NATIVE_INT64, &first_format);  // which takes the seal off
  CHECK(read_snapshot(file.path).particles.count() == 7);
}

TEST_CASE("Snapshot: a number that is not finite or cannot be is refused, with its field") {
  auto snapshot = sample();
  const auto [field, value, reason] = GENERATE(table<Field, double, std::string>(
      {{Field::velocity, std::nan(""), "/particles/velocity: holds a number that is not finite"},
       {Field::pressure, std::numeric_limits<double>::infinity(),
        "/particles/pressure: holds a number that is not finite"},
       {Field::density, 0.0, "/particles/density: holds a number that is not positive"},
       {Field::mass, -1.0, "/particles/mass: holds a number that is not positive"},
       {Field::smoothing_length, 0.0, "/particles/smoothing_length: holds a number that is not positive"}}));
  snapshot.particles.reals(field)[2] = value;
  const Written file(snapshot);
  CHECK_THAT(fault_of([&] { read_snapshot(file.path); }), Contains(reason));
}

TEST_CASE("Snapshot: a count that the data do not have is refused before memory is asked for") {
  const test::TemporaryFolder folder;
  const auto path = folder.file("large.h5");
  auto file = test::unfinished_file(path, 1, std::int64_t{1} << 40);
  file.reals("/particles/density", std::vector<double>(4, 1.0), 1, 4);
  file.close();
  CHECK_THAT(fault_of([&] { read_snapshot(path); }), Contains("/particles/density: has 4 x 1 numbers where"));
}

TEST_CASE("Snapshot: bodies and a time that cannot be are refused with their place") {
  struct Case {
    const char* object;
    const char* name;
    double value;
    std::string says;
  };
  for (const auto& c :
       std::vector<Case>{{"/bodies/0000", "first", 1.0, "/bodies/0000: its range of particles is wrong"},
                         {"/bodies/0000", "count", 0.0, "/bodies/0000: its range of particles is wrong"},
                         {"/bodies/0000", "spacing", 0.0, "/bodies/0000: its spacing is wrong"},
                         {"/bodies/0000", "spacing", std::nan(""), "/bodies/0000: its spacing is wrong"},
                         {"/state", "time", std::nan(""), "/state/@time: is missing or not finite"}}) {
    const test::TemporaryFolder folder;
    const auto path = folder.file("wrong.h5");
    test::unfinished_file(path, 1, 4).close();
    replace(path, c.object, c.name, H5T_NATIVE_DOUBLE, &c.value);
    CHECK_THAT(fault_of([&] { read_snapshot(path); }), Contains(c.says));
  }
}

TEST_CASE("Snapshot: an unknown space, an unknown field, no body and a field that is missing are refused") {
  const test::TemporaryFolder folder;
  const auto path = folder.file("wrong.h5");
  const auto says = [&] { return fault_of([&] { read_snapshot(path); }); };
  test::unfinished_file(path, 1, 4).close();
  CHECK_THAT(says(), Contains("/particles/id: is missing"));

  const hdf5::Handle word(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(word.id(), 4);
  H5Tset_cset(word.id(), H5T_CSET_UTF8);
  replace(path, "/", "space", word.id(), "warp");
  CHECK_THAT(says(), Contains("/@space: unknown space \"warp\""));

  auto field = test::unfinished_file(path, 1, 4);
  field.reals("/particles/charm", std::vector<double>(4, 1.0), 1, 4);
  field.close();
  CHECK_THAT(says(), Contains("/particles/charm: no such field"));

  auto scratch = test::unfinished_file(path, 1, 4);
  scratch.reals("/particles/half_density", std::vector<double>(4, 1.0), 1, 4);
  scratch.close();
  CHECK_THAT(says(), Contains("/particles/half_density: no such field"));

  test::unfinished_file(path, 1, 4).close();
  {
    const hdf5::Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    REQUIRE(H5Ldelete(file.id(), "/bodies/0000", H5P_DEFAULT) >= 0);
  }
  CHECK_THAT(says(), Contains("/bodies: holds no body"));
}

}  // namespace
}  // namespace tektite
