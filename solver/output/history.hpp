#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

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
    Ledger ledger;
    std::vector<double> probes;
  };

  /// A new history.
  History(const std::string& path, int dimensions, const std::vector<std::string>& probe_columns);
  /// Goes on with one, from which the steps after `last_step` are taken: a run that was killed may have written more
  /// steps than its newest snapshot has.
  History(const std::string& path, std::int64_t last_step);

  void write(const Row& row);

 private:
  std::string path_;
  std::ofstream file_;
};

}  // namespace tektite
