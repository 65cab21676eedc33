#pragma once
// The particles of all ranks stand in a file in the order in which a single process has them.

#include <cstdint>
#include <span>
#include <vector>

#include "core/rows_of_file.hpp"
#include "parallel/packed.hpp"

namespace tektite {

/// Which rows each rank writes: about as many each, one rank's behind the other's. All ranks call the same.
class FileOrder : public RowsOfFile {
 public:
  /// Of what each rank owns; the particles have to stay as long as this.
  explicit FileOrder(const Particles& particles);

  const std::vector<Body>& bodies() const override { return bodies_; }
  hdf5::Rows rows() const override { return rows_; }
  /// Brings a field to the ranks that write it; the numbers stay until the next call.
  std::span<const double> reals(Field field) override;
  std::span<const std::int64_t> integers(Field field) override;

 private:
  std::vector<OrderKey> bring_keys();
  template <class Number>
  std::span<const Number> bring(std::span<const Number> own, Field field, std::vector<Number>& rows) const;

  const Particles& particles_;
  std::vector<std::vector<std::uint32_t>> to_;  ///< who is sent to each rank
  std::vector<std::size_t> coming_;             ///< how many come from each
  std::vector<std::uint32_t> place_;            ///< where each that comes stands in the rows
  std::vector<Body> bodies_;
  hdf5::Rows rows_;
  std::vector<double> reals_;
  std::vector<std::int64_t> integers_;
};

}  // namespace tektite
