#pragma once
// What a run has left so far: its snapshots, its history and the solver's summary.

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

#include "postprocess/history.hpp"

namespace tektite {

// NOLINTNEXTLINE(bugprone-exception-escape): what JSON could throw as it goes away, it does not
struct RunFolder {
  std::string path;                    ///< where results are written
  std::vector<std::string> snapshots;  ///< particle files by time, the initial state first; at least one
  std::optional<History> history;
  nlohmann::json summary;  ///< solve.json; an empty object where there is none

  /// A number of the summary, in SI.
  std::optional<double> number(const std::string& name) const;
};

/// Looks into the folder of a run: DIR/snapshots/*.h5, or DIR/particles.h5 where nothing was solved yet. `path` may
/// also be one particle file, which is then shown alone in a folder of its name beside it. `output` (where not empty)
/// is written to instead. Throws InputError where there is nothing to show, and where history or summary are broken.
RunFolder open_run(const std::string& path, const std::string& output);

}  // namespace tektite
