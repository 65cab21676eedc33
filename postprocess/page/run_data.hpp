#pragma once
// What a page shows of a run: all of it has been written before.

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

#include "postprocess/history.hpp"

namespace tektite {

// NOLINTNEXTLINE(bugprone-exception-escape): what JSON could throw as it goes away, it does not
struct RunData {
  std::string folder;
  std::string title;
  std::string space;
  std::string kernel;  ///< with the smoothing ratio
  std::string scene;   ///< the effective one, TOML
  nlohmann::ordered_json measurements;
  std::optional<History> history;
  std::vector<std::string> pictures;  ///< paths of PNG files, by name
};

/// Reads the folder of a run. Throws InputError where there is no run or where it has not been measured.
RunData read_run_data(const std::string& folder);

}  // namespace tektite
