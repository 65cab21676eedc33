#include "core/hdf5.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"

namespace tektite::hdf5 {
namespace {

/// HDF5 prints its own error stack by default; faults are told by us. At the end of a program it would close once more,
/// and crash on, a file that it could not write; ours are closed by their handles. Each thread has an error stack.
void quiet() {
  static thread_local const bool done = [] {
    H5dont_atexit();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    return true;
  }();
  static_cast<void>(done);
}

/// The properties with which something is made. Without the times of its making, equal data make equal files.
Handle made_without_times(hid_t kind) {
  Handle properties(H5Pcreate(kind), H5Pclose);
  H5Pset_obj_track_times(properties.id(), false);
  return properties;
}

Handle create_file(const std::string& path, const Together* together) {
  quiet();
  const auto creation = made_without_times(H5P_FILE_CREATE);
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110);  // metadata with checksums
  if (together) together->open(access.id());
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose};
}

Handle open_file(const std::string& path) {
  quiet();
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose};
}

Handle text_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), std::max<std::size_t>(length, 1));
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

/// Of the rows in a file, these alone.
void select(const Handle& space, const Rows& rows, std::size_t columns) {
  const std::array<hsize_t, 2> start{rows.first, 0}, count{rows.count, columns};
  if (rows.count == 0)
    H5Sselect_none(space.id());
  else
    H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
}

/// Rows in memory.
Handle space_of(std::size_t rows, std::size_t columns) {
  const std::array<hsize_t, 2> shape{rows, columns};
  return {H5Screate_simple(columns == 1 ? 1 : 2, shape.data(), nullptr), H5Sclose};
}

/// How faults name an attribute.
std::string part_of(const std::string& object, const std::string& attribute) {
  return (object == "/" ? "/@" : object + "/@") + attribute;
}

InputError broken(const std::string& path, const std::string& part, const std::string& reason) {
  return InputError({{path, 0}, part, {}, reason, "a particle file of tektite, whole"});
}

}  // namespace

Writer::Writer(const std::string& path, const Together* together)
    : path_(path), together_(together), file_(create_file(path, together)) {
  check(file_.valid(), path + ": cannot be created (is the folder there, writable, and the disk not full?)");
}

void Writer::check(bool fine, const std::string& failure) const {
  if (!(together_ ? together_->everywhere(fine) : fine)) throw RunError(failure);
}

void Writer::group(const std::string& name) {
  const auto properties = made_without_times(H5P_GROUP_CREATE);
  // All in the group's own header: the heaps that hold many members lie elsewhere where several processes write.
  constexpr unsigned most = 65535;
  H5Pset_link_phase_change(properties.id(), most, most);
  H5Pset_attr_phase_change(properties.id(), most, most);
  const Handle group(H5Gcreate2(file_.id(), name.c_str(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Gclose);
  check(group.valid(), fmt::format("{}: {} cannot be written", path_, name));
}

void Writer::dataset(const std::string& name, hid_t type, const void* values, const Rows& rows, std::size_t columns) {
  const auto space = space_of(rows.all, columns), own = space_of(rows.count, columns);
  const auto properties = made_without_times(H5P_DATASET_CREATE);
  // As it is where several processes write: so one leaves the same bytes. What is never written stays a hole.
  H5Pset_alloc_time(properties.id(), H5D_ALLOC_TIME_EARLY);
  H5Pset_fill_time(properties.id(), H5D_FILL_TIME_NEVER);
  const Handle data(H5Dcreate2(file_.id(), name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT),
                    H5Dclose);
  const Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  if (together_) together_->transfer(transfer.id());
  select(space, rows, columns);
  const auto failure = fmt::format("{}: {} cannot be written (is the disk full?)", path_, name);
  check(data.valid(), failure);
  if (rows.all > 0) check(H5Dwrite(data.id(), type, own.id(), space.id(), transfer.id(), values) >= 0, failure);
}

void Writer::reals(const std::string& name, std::span<const double> values, std::size_t columns, const Rows& rows) {
  dataset(name, H5T_NATIVE_DOUBLE, values.data(), rows, columns);
}

void Writer::integers(const std::string& name, std::span<const std::int64_t> values, std::size_t columns,
                      const Rows& rows) {
  dataset(name, H5T_NATIVE_INT64, values.data(), rows, columns);
}

void Writer::text(const std::string& name, const std::string& value) {
  const bool writes = !together_ || together_->first();
  dataset(name, H5T_NATIVE_UCHAR, value.data(), {0, writes ? value.size() : 0, value.size()}, 1);
}

void Writer::attribute(const std::string& object, const std::string& name, hid_t type, const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate_by_name(file_.id(), object.c_str(), name.c_str(), type, space.id(), H5P_DEFAULT,
                                           H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  check(attribute.valid() && H5Awrite(attribute.id(), type, value) >= 0,
        fmt::format("{}: {} cannot be written", path_, part_of(object, name)));
}

void Writer::attribute(const std::string& object, const std::string& name, const std::string& value) {
  attribute(object, name, text_type(value.size()).id(), value.c_str());
}

void Writer::attribute(const std::string& object, const std::string& name, double value) {
  attribute(object, name, H5T_NATIVE_DOUBLE, &value);
}

void Writer::attribute(const std::string& object, const std::string& name, std::int64_t value) {
  attribute(object, name, H5T_NATIVE_INT64, &value);
}

void Writer::close() {
  check(H5Fflush(file_.id(), H5F_SCOPE_GLOBAL) >= 0, path_ + ": cannot be brought to the disk (is the disk full?)");
  const Handle closing(std::move(file_));
}

Reader::Reader(const std::string& path) : path_(path), file_(open_file(path)) {
  if (!file_.valid()) throw broken(path, {}, "cannot be opened as HDF5");
}

bool Reader::has(const std::string& name) const { return H5Lexists(file_.id(), name.c_str(), H5P_DEFAULT) > 0; }

std::vector<std::string> Reader::members(const std::string& group) const {
  const Handle handle(H5Gopen2(file_.id(), group.c_str(), H5P_DEFAULT), H5Gclose);
  if (!handle.valid()) throw broken(path_, group, "is missing or broken");
  std::vector<std::string> names;
  const auto visit = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  if (H5Literate(handle.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, visit, &names) < 0)
    throw broken(path_, group, "cannot be listed");
  return names;
}

Handle Reader::dataset(const std::string& name, hid_t type, std::size_t rows, std::size_t columns) const {
  Handle data(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!data.valid()) throw broken(path_, name, "is missing or broken");
  const Handle space(H5Dget_space(data.id()), H5Sclose);
  const Handle stored(H5Dget_type(data.id()), H5Tclose);
  std::array<hsize_t, 2> shape{0, 1};
  const int rank = H5Sget_simple_extent_ndims(space.id());
  if (rank < 1 || rank > 2 || H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr) < 0)
    throw broken(path_, name, "has no shape that can be read");
  if (rank == 1) shape[1] = 1;
  if (H5Tget_class(stored.id()) != H5Tget_class(type)) throw broken(path_, name, "has the wrong type of numbers");
  if (shape[0] != rows || shape[1] != columns)
    throw broken(path_, name,
                 fmt::format("has {} x {} numbers where {} x {} belong", shape[0], shape[1], rows, columns));
  // A file may claim more than it holds: what is not stored reads as zeros. Packed data may be that much shorter.
  constexpr hsize_t densest_packing = 1100;  // deflate packs up to 1032 bytes into one
  if (rows * columns > densest_packing * H5Dget_storage_size(data.id()))
    throw broken(path_, name, fmt::format("has {} x {} numbers, of which most are not stored", rows, columns));
  return data;
}

void Reader::read(const Handle& data, const std::string& name, hid_t type, void* values, const Rows& rows) const {
  if (rows.count == 0) return;
  const Handle space(H5Dget_space(data.id()), H5Sclose);
  const auto columns = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())) / rows.all;
  select(space, rows, columns);
  const auto own = space_of(rows.count, columns);
  if (H5Dread(data.id(), type, own.id(), space.id(), H5P_DEFAULT, values) < 0)
    throw broken(path_, name, "cannot be read: it is truncated or its checksum is wrong");
}

std::uint64_t Reader::offset(const std::string& name) const {
  const Handle data(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  const auto offset = data.valid() ? H5Dget_offset(data.id()) : HADDR_UNDEF;
  if (offset == HADDR_UNDEF) throw broken(path_, name, "does not lie in one piece");
  return offset;
}

std::vector<double> Reader::reals(const std::string& name, const Rows& rows, std::size_t columns) const {
  const auto data = dataset(name, H5T_NATIVE_DOUBLE, rows.all, columns);
  std::vector<double> values(rows.count * columns);
  read(data, name, H5T_NATIVE_DOUBLE, values.data(), rows);
  return values;
}

std::vector<std::int64_t> Reader::integers(const std::string& name, const Rows& rows, std::size_t columns) const {
  const auto data = dataset(name, H5T_NATIVE_INT64, rows.all, columns);
  std::vector<std::int64_t> values(rows.count * columns);
  read(data, name, H5T_NATIVE_INT64, values.data(), rows);
  return values;
}

std::string Reader::text(const std::string& name) const {
  const Handle data(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!data.valid()) throw broken(path_, name, "is missing or broken");
  const Handle space(H5Dget_space(data.id()), H5Sclose);
  const auto length = H5Sget_simple_extent_npoints(space.id());
  constexpr hssize_t longest = 1 << 24;
  if (length < 0 || length > longest) throw broken(path_, name, "is no text of a sensible length");
  std::string value(static_cast<std::size_t>(length), '\0');
  if (length > 0)
    read(dataset(name, H5T_NATIVE_UCHAR, value.size(), 1), name, H5T_NATIVE_UCHAR, value.data(), value.size());
  return value;
}

Handle Reader::value_attribute(const std::string& object, const std::string& name) const {
  Handle attribute(H5Aopen_by_name(file_.id(), object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!attribute.valid()) throw broken(path_, part_of(object, name), "is missing");
  const Handle space(H5Aget_space(attribute.id()), H5Sclose);
  if (H5Sget_simple_extent_npoints(space.id()) != 1) throw broken(path_, part_of(object, name), "is no single value");
  return attribute;
}

std::string Reader::text_attribute(const std::string& object, const std::string& name) const {
  const auto attribute = value_attribute(object, name);
  const Handle stored(H5Aget_type(attribute.id()), H5Tclose);
  constexpr std::size_t longest = 1 << 16;
  if (H5Tget_class(stored.id()) != H5T_STRING || H5Tis_variable_str(stored.id()) > 0 ||
      H5Tget_size(stored.id()) > longest)
    throw broken(path_, part_of(object, name), "is no text of a sensible length");
  std::string value(H5Tget_size(stored.id()), '\0');
  const auto type = text_type(value.size());
  if (H5Aread(attribute.id(), type.id(), value.data()) < 0)
    throw broken(path_, part_of(object, name), "cannot be read");
  value.resize(std::min(value.find('\0'), value.size()));
  return value;
}

double Reader::real_attribute(const std::string& object, const std::string& name) const {
  const auto attribute = value_attribute(object, name);
  double value = 0.0;
  if (H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, &value) < 0)
    throw broken(path_, part_of(object, name), "is no number");
  return value;
}

std::int64_t Reader::integer_attribute(const std::string& object, const std::string& name) const {
  const auto attribute = value_attribute(object, name);
  std::int64_t value = 0;
  if (H5Aread(attribute.id(), H5T_NATIVE_INT64, &value) < 0)
    throw broken(path_, part_of(object, name), "is no whole number");
  return value;
}

std::vector<std::string> Reader::attributes(const std::string& object) const {
  const Handle handle(H5Oopen(file_.id(), object.c_str(), H5P_DEFAULT), H5Oclose);
  if (!handle.valid()) throw broken(path_, object, "is missing or broken");
  std::vector<std::string> names;
  const auto visit = [](hid_t, const char* name, const H5A_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  if (H5Aiterate2(handle.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, visit, &names) < 0)
    throw broken(path_, object, "has attributes that cannot be listed");
  return names;
}

}  // namespace tektite::hdf5
