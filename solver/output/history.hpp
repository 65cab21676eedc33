#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "core/write_beside.hpp"
#include "schemes/scheme.hpp"

namespace tektite {

/// history.csv: a line a step, in SI units, brought out at once so that a killed run keeps it.
class History {
 public:
  struct Row {
    std::int64_t step = 0;
    double time = 0.0;
    double dt = 0.0;
    const char* reason = "";
    std::int64_t limiting_particle = 0;  ///< id
    std::vector<double> numbers;         ///< energies, momentum and probes, in the order of number_columns()
  };

  /// A new history.
  History(const std::string& path, const std::vector<std::string>& number_columns);
  /// Goes on with one that has a line every `interval` steps, and from which the steps after `last_step` are taken: a
  /// run that was killed may have written more steps than its newest snapshot has. Throws InputError where it does not
  /// reach as far as `last_step`.
  History(const std::string& path, std::int64_t last_step, std::int64_t interval);

  void write(const Row& row);
  /// All lines so far outlive the machine.
  void bring_to_disk() const { tektite::bring_to_disk(path_); }

 private:
  std::string path_;
  std::ofstream file_;
};

/// Names of a line's numbers.
std::vector<std::string> number_columns(Space space, const std::vector<std::string>& probe_columns);
/// A line's numbers.
std::vector<double> numbers_of(const Ledger& ledger, const std::vector<double>& angular_momentum,
                               const std::vector<double>& probes);

}  // namespace tektite
