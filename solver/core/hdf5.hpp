#pragma once
// The little of HDF5 that tektite needs, with handles that close themselves and faults that name the file and the part.
// A dataset lies in one piece, its rows one behind the other, as whoever writes a part of them without HDF5 expects.
// Whether its bytes are as they were, the seal behind the file tells (seal.hpp).

#include <hdf5.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tektite::hdf5 {

class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = H5I_INVALID_HID; }
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  hid_t id() const { return id_; }
  bool valid() const { return id_ >= 0; }

 private:
  hid_t id_;
  Close close_;
};

/// Of a dataset of `all` rows the `count` from `first` on.
struct Rows {
  Rows(std::size_t whole) : count(whole), all(whole) {}  // NOLINT(google-explicit-constructor): all of them
  Rows(std::size_t first_row, std::size_t how_many, std::size_t whole)
      : first(first_row), count(how_many), all(whole) {}
  std::size_t first = 0, count, all;
};

/// Several processes that write a file together: each calls the same, with its own rows.
class Together {
 public:
  virtual ~Together() = default;
  virtual void open(hid_t access) const = 0;          ///< sets how the file is opened
  virtual void transfer(hid_t properties) const = 0;  ///< and how rows are written
  virtual bool first() const = 0;                     ///< whether this is the one that writes what all have
  virtual bool everywhere(bool fine) const = 0;       ///< whether it is so in every process
};

class Writer {
 public:
  /// Creates the file; throws RunError where that is impossible, here and in every call below: in all processes.
  explicit Writer(const std::string& path, const Together* together = nullptr);
  void group(const std::string& name);
  /// A dataset of rows x columns, of which these values are some; `columns` 1 gives a plain list.
  void reals(const std::string& name, std::span<const double> values, std::size_t columns, const Rows& rows);
  void integers(const std::string& name, std::span<const std::int64_t> values, std::size_t columns, const Rows& rows);
  void text(const std::string& name, const std::string& value);
  void attribute(const std::string& object, const std::string& name, const std::string& value);
  void attribute(const std::string& object, const std::string& name, double value);
  void attribute(const std::string& object, const std::string& name, std::int64_t value);
  /// Brings everything to the disk and closes.
  void close();

 private:
  void dataset(const std::string& name, hid_t type, const void* values, const Rows& rows, std::size_t columns);
  void attribute(const std::string& object, const std::string& name, hid_t type, const void* value);
  void check(bool fine, const std::string& failure) const;
  std::string path_;
  const Together* together_;
  Handle file_;
};

class Reader {
 public:
  /// Opens the file; throws InputError where it is missing, foreign or broken, here and in every call below.
  explicit Reader(const std::string& path);
  bool has(const std::string& name) const;
  std::vector<std::string> members(const std::string& group) const;
  /// The byte of the file at which the rows of a dataset begin.
  std::uint64_t offset(const std::string& name) const;
  std::vector<double> reals(const std::string& name, const Rows& rows, std::size_t columns) const;
  std::vector<std::int64_t> integers(const std::string& name, const Rows& rows, std::size_t columns) const;
  std::string text(const std::string& name) const;
  std::string text_attribute(const std::string& object, const std::string& name) const;
  double real_attribute(const std::string& object, const std::string& name) const;
  std::int64_t integer_attribute(const std::string& object, const std::string& name) const;
  /// Names of the numbers that an object carries as attributes.
  std::vector<std::string> attributes(const std::string& object) const;
  const std::string& path() const { return path_; }

 private:
  /// An attribute that is there and holds one value.
  Handle value_attribute(const std::string& object, const std::string& name) const;
  /// The dataset, once its type and shape are what is expected and its data are there: memory is asked for only after.
  Handle dataset(const std::string& name, hid_t type, std::size_t rows, std::size_t columns) const;
  void read(const Handle& data, const std::string& name, hid_t type, void* values, const Rows& rows) const;
  std::string path_;
  Handle file_;
};

}  // namespace tektite::hdf5
