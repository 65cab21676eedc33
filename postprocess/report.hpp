#pragma once
// What was measured, as a file and as a table: ours beside published.

#include <string>
#include <vector>

#include "postprocess/references.hpp"
#include "postprocess/run_folder.hpp"

namespace tektite {

struct Measurement {
  std::string name;
  std::string unit;
  Measured measured;
};

struct Report {
  std::string scene;
  std::string variant;
  double time = 0.0;          ///< in s
  std::size_t particles = 0;  ///< computed ones
  std::vector<Measurement> measurements;
  std::vector<std::string> missing;  ///< "NAME: why it could not be measured"
  std::vector<Reference> references;
};

/// Writes measurements.json: the run's summary, the measurements and the references with their differences (relative
/// to the published value; null where that is zero). Throws RunError.
void write_measurements(const Report& report, const RunFolder& run, const std::string& path);

/// The table of ours beside published, one line a reference, then the measures without a reference.
std::string comparison_table(const Report& report, const RunFolder& run);

}  // namespace tektite
