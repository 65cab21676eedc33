#include "postprocess/run_folder.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "core/snapshot_files.hpp"

namespace tektite {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> particle_files(const fs::path& folder) {
  auto files = snapshot_files(folder);
  if (files.empty() && fs::exists(folder / "particles.h5")) files.push_back((folder / "particles.h5").string());
  return files;
}

nlohmann::json read_summary(const fs::path& path) {
  if (!fs::exists(path)) return nlohmann::json::object();
  std::ifstream file(path);
  auto summary = nlohmann::json::parse(file, nullptr, false);
  if (summary.is_discarded() || !summary.is_object())
    throw InputError({{path.string(), 0}, {}, {}, "not a JSON object", "the solver's summary, whole"});
  return summary;
}

}  // namespace

std::optional<double> RunFolder::number(const std::string& name) const {
  const auto found = summary.find(name);
  if (found == summary.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

RunFolder open_run(const std::string& path, const std::string& output) {
  RunFolder run;
  if (fs::is_regular_file(path)) {
    run.path = fs::path(path).replace_extension().string();
    run.snapshots = {path};
    run.summary = nlohmann::json::object();
  } else {
    if (!fs::is_directory(path)) throw InputError({{path, 0}, {}, {}, "there is no such folder or file", {}});
    run.path = path;
    run.snapshots = particle_files(path);
    if (run.snapshots.empty())
      throw InputError({{path, 0}, {}, {}, "holds no particles", "a folder with particles.h5 or snapshots/*.h5"});
    const auto history = fs::path(path) / "history.csv";
    if (fs::exists(history)) run.history = History::read(history.string());
    run.summary = read_summary(fs::path(path) / "solve.json");
  }
  if (!output.empty()) run.path = output;
  return run;
}

}  // namespace tektite
