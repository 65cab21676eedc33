// Particle files that are cut, changed, foreign or newer: a clear error with exit code 2, or the right result.
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>
#include <random>

#include "core/error.hpp"
#include "core/hdf5.hpp"
#include "core/seal.hpp"
#include "core/snapshot.hpp"
#include "robustness/small_run.hpp"
#include "support/unfinished_file.hpp"

namespace {

namespace fs = std::filesystem;
using namespace tektite;
using namespace tektite::test;
using Catch::Matchers::Contains;

void write_bytes(const std::string& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

std::string cut(const std::string& bytes, std::mt19937& random) { return bytes.substr(0, random() % bytes.size()); }

std::string flipped(std::string bytes, std::mt19937& random, int flips) {
  for (int k = 0; k < flips; ++k) {
    auto& byte = bytes[random() % bytes.size()];
    byte = static_cast<char>(byte ^ (1 << random() % 8));
  }
  return bytes;
}

/// A finished run whose files are spoilt one after another.
class Spoilt {
 public:
  Spoilt() : small_("eulerian"), whole_(small_.unbroken()) {
    particles_ = content_of(small_.folder("unbroken/particles.h5"));
    last_ = small_.folder("unbroken/snapshots/" + whole_.snapshots.back());
  }

  const std::string& particles() const { return particles_; }
  const std::string& last() const { return whole_.last_snapshot; }

  /// particles.h5 is given to the solver, which says what a run of it would do.
  void give_particles(const std::string& bytes) const {
    write_bytes(small_.folder("spoilt.h5"), bytes);
    check(run_in(small_.path(), {stage_program("solve"), "--check", "spoilt.h5", "--threads", "1"}, limit_resources),
          "spoilt.h5");
  }
  /// The last snapshot is given to the solver, which goes on with it, and to postprocess.
  void give_last_snapshot(const std::string& bytes) const {
    write_bytes(last_, bytes);
    const bool resumed = check(run_in(small_.path(), small_.resuming("unbroken"), limit_resources), last_);
    if (resumed) CHECK(content_of(small_.folder("unbroken/history.csv")) == whole_.history);
    const bool measured = check(
        run_in(small_.path(), {stage_program("postprocess"), "unbroken", "--no-pictures"}, limit_resources), last_);
    CHECK(measured == resumed);
    if (measured) CHECK(test::measured(content_of(small_.folder("unbroken/measurements.json"))) == whole_.measurements);
    write_bytes(last_, whole_.last_snapshot);
  }
  const SmallRun& small() const { return small_; }

 private:
  /// Whether the program did its work; else it has told what is wrong with the file.
  static bool check(const Outcome& outcome, const std::string& file) {
    INFO(outcome.faults);
    CHECK((outcome.code == 0 || outcome.code == 2));
    if (outcome.code == 2) CHECK_THAT(outcome.faults, Contains(fs::path(file).filename().string() + ": "));
    if (outcome.code == 2) CHECK(std::count(outcome.faults.begin(), outcome.faults.end(), '\n') == 1);
    return outcome.code == 0;
  }

  SmallRun small_;
  Left whole_;
  std::string particles_;
  std::string last_;
};

void spoil(int times, unsigned seed) {
  INFO("TEKTITE_SEED=" << seed);
  std::mt19937 random(seed);
  const Spoilt spoilt;
  for (int k = 0; k < times; ++k) {
    INFO("number " << k);
    spoilt.give_particles(cut(spoilt.particles(), random));
    spoilt.give_particles(flipped(spoilt.particles(), random, 1));
    spoilt.give_last_snapshot(cut(spoilt.last(), random));
    spoilt.give_last_snapshot(flipped(spoilt.last(), random, 1));
  }
}

TEST_CASE("Broken files: cut or with a bit flipped, they are refused by every program") { spoil(4, seed()); }

TEST_CASE("Broken files: the same, two hundred times", "[.long]") { spoil(200, seed()); }

/// Without its seal a file is at the mercy of the HDF5 library, until its format is known to need one.
void spoil_unsealed(int times, unsigned seed) {
  INFO("TEKTITE_SEED=" << seed);
  std::mt19937 random(seed);
  const SmallRun small("adaptle");
  small.fill("run");
  const auto path = small.folder("run/particles.h5");
  constexpr std::size_t seal = 16;
  auto bytes = content_of(path);
  bytes.resize(bytes.size() - seal);
  for (int k = 0; k < times; ++k) {
    INFO("number " << k);
    write_bytes(path, k % 4 == 0 ? cut(bytes, random) : flipped(bytes, random, 1 + k % 3));
    CHECK_THROWS_AS(read_snapshot(path), InputError);
    CHECK_THROWS_WITH(read_snapshot(path), Contains("particles.h5"));
  }
}

TEST_CASE("Broken files: those without a seal are refused") { spoil_unsealed(50, seed()); }

TEST_CASE("Broken files: five thousand without a seal", "[.long]") { spoil_unsealed(5000, seed()); }

TEST_CASE("Broken files: a newer format is refused by every program, with both versions") {
  const TemporaryFolder folder;
  fs::create_directories(folder.file("run/snapshots"));
  unfinished_file(folder.file("run/particles.h5"), particle_format_version + 1, 4).close();
  fs::copy(folder.file("run/particles.h5"), folder.file("run/snapshots/000000.h5"));
  const std::vector<std::vector<std::string>> programs{
      {TEKTITE_PROGRAM, "solve", "run"}, {TEKTITE_PROGRAM, "resume", "run"}, {TEKTITE_PROGRAM, "postprocess", "run"}};
  const auto says = "format " + std::to_string(particle_format_version + 1) +
                    " is not known to this program, which reads up to " + std::to_string(particle_format_version);
  for (const auto& words : programs) {
    INFO(words[1]);
    const auto outcome = run_in(folder.path(), words);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.faults, Contains(says));
  }
}

/// Adds an object to a file by the HDF5 library itself.
template <class Work>
void add(const std::string& path, const Work& work) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  work(file);
  H5Fclose(file);
}

void refused(const std::string& path, const std::string& reason) {
  CHECK_THROWS_AS(read_snapshot(path), InputError);
  CHECK_THROWS_WITH(read_snapshot(path), Contains(reason));
}

TEST_CASE("Foreign files: a snapshot whose state lacks a number that the run needs is refused, with its name") {
  // Of the run itself, of a probe, of the neighbours, of what a scheme counts,
  // and of two bodies in touch, where it can only be told that there are too few of them.
  const std::string pair = "contact_at_start_0_1";
  const auto [scheme, name] = GENERATE(table<std::string, std::string>({{"eulerian", "largest_energy"},
                                                                        {"eulerian", "probe.centre"},
                                                                        {"eulerian", "stop_when.perforated.front"},
                                                                        {"godunov-pm", "search_reach"},
                                                                        {"msph", "first_order_particle_steps"},
                                                                        {"adaptle", "contact_bodies_in_touch"},
                                                                        {"adaptle", "contact_at_start_0_1"},
                                                                        {"total-lagrangian", "hourglass_energy"}}));
  INFO(scheme << ": " << name);
  std::vector<std::string> settings{"time.end=1 us", "output.snapshots=1 us"};
  if (scheme == "eulerian") settings.emplace_back("stop_when.perforated={projectile='bar', body='plate'}");
  if (scheme == "total-lagrangian") settings.emplace_back("scheme.hourglass_control=0.1");
  if (name == pair) settings.emplace_back("body.plate.shape.lower=['-0.5 mm', '-15 mm']");
  const SmallRun small(scheme, settings);
  small.fill("run");
  REQUIRE(small.program(small.solving("run")).code == 0);
  const auto last = tektite::snapshot_files(small.folder("run")).back();
  REQUIRE(small.program(small.resuming("run")).code == 0);
  add(last, [&name = name](hid_t file) { REQUIRE(H5Adelete_by_name(file, "/state", name.c_str(), H5P_DEFAULT) >= 0); });
  seal(last);
  const auto outcome = small.program(small.resuming("run"));
  CHECK(outcome.code == 2);
  const auto path = "run/snapshots/" + fs::path(last).filename().string();
  CHECK(outcome.faults == "tektite-solve: error: " + path + ": /state/@" +
                              (name == pair ? "contact_at_start_BODY_BODY" : name) +
                              ": is missing (allowed: a snapshot of this scene, whole)\n");
}

/// In place of the group of particles one that lists its members in a tree, as HDF5 does by itself where there are
/// many.
void list_members_in_a_tree(const std::string& path) {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS), creation = H5Pcreate(H5P_GROUP_CREATE);
  H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
  H5Pset_link_phase_change(creation, 0, 0);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, access);
  REQUIRE(H5Ldelete(file, "/particles", H5P_DEFAULT) >= 0);
  const hid_t group = H5Gcreate2(file, "/particles", H5P_DEFAULT, creation, H5P_DEFAULT);
  for (const char* name : {"density", "mass"})
    REQUIRE(H5Lcreate_hard(file, "/bodies", group, name, H5P_DEFAULT, H5P_DEFAULT) >= 0);
  H5Gclose(group);
  H5Fclose(file);
  H5Pclose(creation);
  H5Pclose(access);
}

TEST_CASE("Foreign files: one whose list of members is spoilt is refused, whether HDF5 survives it or not") {
  const TemporaryFolder folder;
  const auto path = folder.file("spoilt.h5");
  unfinished_file(path, 1, 4).close();
  list_members_in_a_tree(path);
  auto bytes = content_of(path);
  const std::string leaf_of_members("BTLF\0\5", 6);  // version 0, type 5: names of links
  auto at = bytes.find(leaf_of_members);
  REQUIRE(at != std::string::npos);
  for (; at != std::string::npos; at = bytes.find(leaf_of_members)) bytes.replace(at, 4, "none");
  write_bytes(path, bytes);
  // As the heap lies, the library fails on it in the process that tries the file, or says that it cannot list them.
  CHECK_THROWS_AS(read_snapshot(path), InputError);
  CHECK_THROWS_WITH(read_snapshot(path),
                    Contains(path) && (Contains("the HDF5 library fails on it") || Contains("cannot be listed")));
}

TEST_CASE("Foreign files: an attribute with many values where one belongs is refused") {
  const TemporaryFolder folder;
  const auto path = folder.file("many.h5");
  unfinished_file(path, 1, 4).close();
  add(path, [](hid_t file) {
    const std::vector<double> values(4000, 1.0);
    const hsize_t count = values.size();
    const hid_t space = H5Screate_simple(1, &count, nullptr);
    const hid_t attribute =
        H5Acreate_by_name(file, "/state", "step", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    REQUIRE(H5Awrite(attribute, H5T_NATIVE_DOUBLE, values.data()) >= 0);
    H5Aclose(attribute);
    H5Sclose(space);
  });
  refused(path, "/state/@step: is no single value");
}

TEST_CASE("Foreign files: numbers that are claimed and not stored are refused before memory is asked for") {
  const TemporaryFolder folder;
  const auto path = folder.file("claimed.h5");
  static constexpr hsize_t count = hsize_t{1} << 36;
  unfinished_file(path, 1, count).close();
  add(path, [](hid_t file) {
    const hsize_t chunk = 1024;
    const hid_t space = H5Screate_simple(1, &count, nullptr);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(properties, 1, &chunk);
    const hid_t data =
        H5Dcreate2(file, "/particles/density", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    REQUIRE(data >= 0);
    H5Dclose(data);
    H5Pclose(properties);
    H5Sclose(space);
  });
  refused(path, "/particles/density: has 68719476736 x 1 numbers, of which most are not stored");
}

/// Makes a dataset of so many zeros by packing its first chunk and storing that again for every other one.
void add_packed_zeros(hid_t file, const char* name, hsize_t count, hsize_t chunk) {
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
  constexpr unsigned strongest = 9;
  H5Pset_chunk(properties, 1, &chunk);
  H5Pset_deflate(properties, strongest);
  const hid_t data = H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, properties, H5P_DEFAULT);
  const hid_t first = H5Screate_simple(1, &chunk, nullptr);
  const hsize_t start = 0;
  H5Sselect_hyperslab(space, H5S_SELECT_SET, &start, nullptr, &chunk, nullptr);
  const std::vector<double> zeros(chunk);
  REQUIRE(H5Dwrite(data, H5T_NATIVE_DOUBLE, first, space, H5P_DEFAULT, zeros.data()) >= 0);
  H5Fflush(file, H5F_SCOPE_LOCAL);
  hsize_t size = 0;
  REQUIRE(H5Dget_chunk_storage_size(data, &start, &size) >= 0);
  std::vector<char> packed(size);
  std::uint32_t filters = 0;
  REQUIRE(H5Dread_chunk(data, H5P_DEFAULT, &start, &filters, packed.data()) >= 0);
  for (hsize_t at = chunk; at < count; at += chunk)
    REQUIRE(H5Dwrite_chunk(data, H5P_DEFAULT, filters, &at, size, packed.data()) >= 0);
  H5Sclose(first);
  H5Dclose(data);
  H5Pclose(properties);
  H5Sclose(space);
}

TEST_CASE("Foreign files: one that needs a thousand times the memory of its bytes is refused before it is asked for") {
  const TemporaryFolder folder;
  const auto path = folder.file("packed.h5");
  static constexpr hsize_t chunk = hsize_t{1} << 20, count = 512 * chunk;  // 4 GB in 4 MB
  unfinished_file(path, 1, count).close();
  add(path, [](hid_t file) { add_packed_zeros(file, "/particles/density", count, chunk); });
  CHECK(fs::file_size(path) < 8'000'000);
  refused(path, "the HDF5 library fails on it");
}

TEST_CASE("Foreign files: what is no particle file is refused by every program") {
  const TemporaryFolder folder;
  fs::create_directories(folder.file("run/snapshots"));
  const auto path = folder.file("run/particles.h5");
  const auto [name, reason] = GENERATE(table<std::string, std::string>({{"empty", "cannot be opened as HDF5"},
                                                                        {"text", "cannot be opened as HDF5"},
                                                                        {"other HDF5", "/@format"},
                                                                        {"a folder", "this is no file"}}));
  INFO(name);
  if (name == "empty") write_bytes(path, "");
  if (name == "text") write_bytes(path, "name = \"a scene\"\n");
  if (name == "other HDF5") {
    hdf5::Writer file(path);
    file.text("/note", "from elsewhere");
    file.close();
  }
  if (name == "a folder") fs::create_directory(path);
  fs::copy(path, folder.file("run/snapshots/000000.h5"), fs::copy_options::recursive);
  for (const std::string command : {"solve", "resume", "postprocess"}) {
    INFO(command);
    const auto outcome = run_in(folder.path(), {TEKTITE_PROGRAM, command, "run"}, limit_resources);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.faults, Contains(reason));
  }
}

}  // namespace
