#include "postprocess/page/run_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "postprocess/run_folder.hpp"

namespace tektite {
namespace {

namespace fs = std::filesystem;

nlohmann::ordered_json read_measurements(const fs::path& path) {
  std::ifstream file(path);
  if (!file)
    throw InputError({{path.string(), 0}, {}, {}, "this run has not been measured", "tektite postprocess DIR first"});
  auto json = nlohmann::ordered_json::parse(file, nullptr, false);
  if (!json.is_object() || !json.contains("measurements") || !json.contains("references"))
    throw InputError(
        {{path.string(), 0}, {}, {}, "not what tektite-postprocess writes", "tektite postprocess DIR first"});
  return json;
}

std::vector<std::string> pictures_in(const fs::path& folder) {
  std::vector<std::string> paths;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".png") paths.push_back(entry.path().string());
  std::ranges::sort(paths);
  return paths;
}

}  // namespace

RunData read_run_data(const std::string& folder) {
  auto run = open_run(folder, "");
  const auto last = read_snapshot(run.snapshots.back());
  auto document = Document::parse(last.scene, run.snapshots.back());
  auto root = document.root();
  const auto scene = read_scene(root, Stage::postprocess);
  RunData data;
  data.folder = folder;
  data.title = scene.title;
  data.space = std::string(name_of(scene.space));
  data.kernel = fmt::format("{}, h/δ {}", scene.kernel, scene.smoothing_ratio);
  data.scene = last.scene.substr(0, last.scene.find("\n#@ "));  // what follows tells where each key came from
  data.measurements = read_measurements(fs::path(folder) / "measurements.json");
  data.history = std::move(run.history);
  data.pictures = pictures_in(fs::path(folder) / "pictures");
  return data;
}

}  // namespace tektite
