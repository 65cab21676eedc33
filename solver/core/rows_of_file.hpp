#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/hdf5.hpp"
#include "core/particles.hpp"

namespace tektite {

/// What a process writes of the particles of a file: some rows of each field, asked for one field after the other.
class RowsOfFile {
 public:
  virtual ~RowsOfFile() = default;
  virtual const std::vector<Body>& bodies() const = 0;  ///< with their rows in the file
  virtual hdf5::Rows rows() const = 0;
  /// The numbers of its rows, until the next call.
  virtual std::span<const double> reals(Field field) = 0;
  virtual std::span<const std::int64_t> integers(Field field) = 0;
};

}  // namespace tektite
