#include "core/snapshot_files.hpp"

#include <fmt/format.h>

#include <charconv>
#include <map>

#include "core/write_beside.hpp"

namespace tektite {
namespace fs = std::filesystem;

std::string snapshot_path(const fs::path& folder, std::int64_t step) {
  return (folder / "snapshots" / fmt::format("{:06}.h5", step)).string();
}

std::vector<std::string> snapshot_files(const fs::path& folder) {
  std::map<std::int64_t, std::string> by_step;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder / "snapshots", missing)) {
    const auto name = entry.path().stem().string();
    std::int64_t step = 0;
    std::from_chars(name.data(), name.data() + name.size(), step);
    if (const auto path = snapshot_path(folder, step); entry.path() == path) by_step[step] = path;
  }
  std::vector<std::string> files;
  for (const auto& [step, path] : by_step) files.push_back(path);
  return files;
}

void remove_parts_of_snapshots(const fs::path& folder) {
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder / "snapshots", missing))
    if (entry.path().extension() == part_ending) fs::remove(entry.path());
}

}  // namespace tektite
