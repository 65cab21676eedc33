// What a file holds in another shape, type or length than asked for is refused, with its place.
#include "core/hdf5.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "support/fault.hpp"
#include "support/temporary_folder.hpp"

namespace tektite {
namespace {

using Catch::Matchers::Contains;
using hdf5::Handle;

/// A dataset whose numbers are not stored.
void claim(const std::string& path, const char* name, const std::vector<hsize_t>& shape, hid_t type) {
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
  const Handle data(H5Dcreate2(file.id(), name, type, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  REQUIRE(data.valid());
}

/// An attribute of two numbers at the root.
void attach_two(const std::string& path, const char* name) {
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  const std::array<hsize_t, 1> two{2};
  const Handle space(H5Screate_simple(1, two.data(), nullptr), H5Sclose);
  const Handle attribute(H5Acreate2(file.id(), name, H5T_NATIVE_DOUBLE, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  const std::array<double, 2> values{1.0, 2.0};
  REQUIRE(H5Awrite(attribute.id(), H5T_NATIVE_DOUBLE, values.data()) >= 0);
}

/// A text whose letters are said to be ASCII, which ours never are: HDF5 does not read one as the other.
void attach_ascii(const std::string& path, const char* name) {
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(file.id(), name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  REQUIRE(H5Awrite(attribute.id(), type.id(), "a") >= 0);
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A file whose root has more members and attributes than stand in its header, and whose lists of them are spoilt.
void write_unlisted(const std::string& path) {
  {
    hdf5::Writer writer(path);
    for (int k = 0; k < 40; ++k) {
      writer.group("/group" + std::to_string(k));
      writer.attribute("/", "number" + std::to_string(k), 1.0);
    }
    writer.close();
  }
  auto bytes = bytes_of(path);
  const std::string head_of_list = "BTHD";  // the leaves themselves HDF5 does not survive
  for (auto at = bytes.find(head_of_list); at != std::string::npos; at = bytes.find(head_of_list))
    bytes.replace(at, head_of_list.size(), "none");
  std::ofstream(path, std::ios::binary) << bytes;
}

struct File {
  File() {
    hdf5::Writer writer(path);
    writer.reals("/four", std::vector<double>(4, 1.0), 1, 4);
    writer.integers("/whole", std::vector<std::int64_t>(4, 1), 1, 4);
    writer.attribute("/", "word", std::string("word"));
    writer.attribute("/", "number", 1.5);
    writer.close();
    claim(path, "cube", {2, 2, 2}, H5T_NATIVE_DOUBLE);
    claim(path, "promised", {1 << 20}, H5T_NATIVE_DOUBLE);
    claim(path, "endless", {(1 << 24) + 1}, H5T_NATIVE_UCHAR);
    attach_two(path, "two");
    attach_ascii(path, "ascii");
  }
  test::TemporaryFolder folder;
  std::string path = folder.file("file.h5");
};

}  // namespace

TEST_CASE("HDF5: what is not as asked for is refused with file, place and reason") {
  using hdf5::Reader;
  struct Case {
    std::function<void(const Reader&)> read;
    std::string says;
  };
  const File file;
  const Reader reader(file.path);
  for (const auto& [read, says] : std::vector<Case>{
           {[](const Reader& r) { r.reals("/none", 4, 1); }, "/none: is missing or broken"},
           {[](const Reader& r) { r.text("/none"); }, "/none: is missing or broken"},
           {[](const Reader& r) { r.members("/none"); }, "/none: is missing or broken"},
           {[](const Reader& r) { r.attributes("/none"); }, "/none: is missing or broken"},
           {[](const Reader& r) { r.real_attribute("/", "none"); }, "/@none: is missing"},
           {[](const Reader& r) { r.reals("/cube", 4, 2); }, "/cube: has no shape that can be read"},
           {[](const Reader& r) { r.reals("/whole", 4, 1); }, "/whole: has the wrong type of numbers"},
           {[](const Reader& r) { r.integers("/four", 4, 1); }, "/four: has the wrong type of numbers"},
           {[](const Reader& r) { r.reals("/four", 2, 2); }, "/four: has 4 x 1 numbers where 2 x 2 belong"},
           {[](const Reader& r) { r.reals("/promised", 1 << 20, 1); },
            "/promised: has 1048576 x 1 numbers, of which most are not stored"},
           {[](const Reader& r) { r.text("/endless"); }, "/endless: is no text of a sensible length"},
           {[](const Reader& r) { r.real_attribute("/", "two"); }, "/@two: is no single value"},
           {[](const Reader& r) { r.text_attribute("/", "number"); }, "/@number: is no text of a sensible length"},
           {[](const Reader& r) { r.text_attribute("/", "ascii"); }, "/@ascii: cannot be read"},
           {[](const Reader& r) { r.real_attribute("/", "word"); }, "/@word: is no number"},
           {[](const Reader& r) { r.integer_attribute("/", "word"); }, "/@word: is no whole number"}}) {
    const auto fault = test::fault_of([&] { read(reader); });
    CHECK_THAT(fault, Contains("file.h5") && Contains(says));
  }
}

TEST_CASE("HDF5: members and attributes of which the list is spoilt are refused with file and place") {
  const test::TemporaryFolder folder;
  write_unlisted(folder.file("spoilt.h5"));
  const hdf5::Reader reader(folder.file("spoilt.h5"));
  CHECK_THAT(test::fault_of([&] { reader.members("/"); }), Contains("spoilt.h5: /: cannot be listed"));
  CHECK_THAT(test::fault_of([&] { reader.attributes("/"); }),
             Contains("spoilt.h5: /: has attributes that cannot be listed"));
}

/// Numbers in a piece of their own with a checksum, as others store them.
void write_checked(const std::string& path, const char* name, const std::vector<double>& numbers) {
  const Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  const hsize_t count = numbers.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_chunk(properties.id(), 1, &count);
  H5Pset_fletcher32(properties.id());
  const Handle data(
      H5Dcreate2(file.id(), name, H5T_NATIVE_DOUBLE, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Dclose);
  REQUIRE(H5Dwrite(data.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) >= 0);
}

std::string bytes_of(const std::vector<double>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), sizeof(double) * numbers.size()};
}

TEST_CASE("HDF5: numbers that are not those of their checksum are refused with file and place") {
  const test::TemporaryFolder folder;
  const auto path = folder.file("changed.h5");
  const std::vector<double> numbers(4, 1234.5);
  write_checked(path, "/four", numbers);
  CHECK(hdf5::Reader(path).reals("/four", 4, 1) == numbers);
  auto bytes = bytes_of(path);
  const auto at = bytes.find(bytes_of(numbers));
  REQUIRE(at != std::string::npos);
  bytes[at] = static_cast<char>(bytes[at] ^ 1);
  std::ofstream(path, std::ios::binary) << bytes;
  const hdf5::Reader reader(path);
  CHECK_THAT(test::fault_of([&] { reader.reals("/four", 4, 1); }),
             Contains("changed.h5: /four: cannot be read: it is truncated or its checksum is wrong"));
}

TEST_CASE("HDF5: the rows of a dataset lie one behind the other where its offset says") {
  const test::TemporaryFolder folder;
  const auto path = folder.file("rows.h5");
  constexpr std::size_t rows = 100'000;
  std::vector<double> numbers(3 * rows);
  for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = static_cast<double>(k);
  {
    hdf5::Writer writer(path);
    writer.reals("/before", numbers, 1, numbers.size());
    writer.reals("/numbers", numbers, 3, rows);
    writer.close();
  }
  const auto offset = hdf5::Reader(path).offset("/numbers");
  CHECK(bytes_of(path).substr(offset, sizeof(double) * numbers.size()) == bytes_of(numbers));

  const auto others = folder.file("others.h5");
  write_checked(others, "/four", std::vector<double>(4, 1.0));
  CHECK_THAT(test::fault_of([&] { hdf5::Reader(others).offset("/four"); }),
             Contains("others.h5: /four: does not lie in one piece"));
  CHECK_THAT(test::fault_of([&] { hdf5::Reader(others).offset("/none"); }),
             Contains("/none: does not lie in one piece"));
}

TEST_CASE("HDF5: what cannot be written is told with file and place") {
  CHECK_THROWS_WITH(hdf5::Writer("/no/such/folder/file.h5"), Contains("file.h5: cannot be created"));
  const test::TemporaryFolder folder;
  hdf5::Writer writer(folder.file("twice.h5"));
  writer.group("/group");
  CHECK_THROWS_WITH(writer.group("/group"), Contains("twice.h5: /group cannot be written"));
  CHECK_THROWS_WITH(writer.reals("/group", std::vector<double>(1, 1.0), 1, 1), Contains("/group cannot be written"));
  CHECK_THROWS_WITH(writer.attribute("/none", "name", 1.0), Contains("/none/@name cannot be written"));
  CHECK_THROWS_WITH(writer.attribute("/none", "name", std::int64_t{1}), Contains("/none/@name cannot be written"));
  CHECK_THROWS_WITH(writer.attribute("/none", "name", std::string("text")), Contains("/none/@name cannot be written"));
}

}  // namespace tektite
