#include "run/snapshots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "core/error.hpp"

namespace tektite {
namespace {

namespace fs = std::filesystem;

/// Snapshots by step; files with other names are not ours.
std::map<std::int64_t, fs::path> snapshots(const fs::path& folder) {
  std::map<std::int64_t, fs::path> found;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder / "snapshots", missing)) {
    const auto stem = entry.path().stem().string();
    std::int64_t step = 0;
    const auto [end, fault] = std::from_chars(stem.data(), stem.data() + stem.size(), step);
    if (fault == std::errc{} && end == stem.data() + stem.size() && entry.path().extension() == ".h5")
      found[step] = entry.path();
  }
  return found;
}

}  // namespace

std::string snapshot_path(const fs::path& folder, std::int64_t step) {
  return (folder / "snapshots" / fmt::format("{:06}.h5", step)).string();
}

std::string newest_snapshot(const fs::path& folder) {
  const auto found = snapshots(folder);
  if (found.empty())
    throw InputError(
        {{folder.string(), 0}, {}, {}, "there is no snapshot to go on from", "the folder of a run that was started"});
  return found.rbegin()->second.string();
}

void remove_snapshots(const fs::path& folder) {
  for (const auto& [step, path] : snapshots(folder)) fs::remove(path);
}

}  // namespace tektite
