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

using Json = nlohmann::ordered_json;

bool has_number(const Json& entry, const char* key) { return entry.contains(key) && entry[key].is_number(); }
bool has_text(const Json& entry, const char* key) { return entry.contains(key) && entry[key].is_string(); }

/// Whether it holds all that the page reads of measures and references.
bool is_whole(const Json& file) {
  if (!file.is_object() || !file.contains("measurements") || !file.contains("references")) return false;
  const auto is_measurement = [](const Json& m) {
    return has_number(m, "value") && has_number(m, "uncertainty") && has_text(m, "unit");
  };
  const auto is_reference = [](const Json& r) {
    return has_text(r, "measure") && has_text(r, "unit") && has_text(r, "source") && has_number(r, "published") &&
           (!r.contains("within") || r["within"].is_boolean());
  };
  for (const auto* key : {"particles", "steps", "threads", "peak_memory_bytes"})
    if (file.contains(key) && !file[key].is_number()) return false;
  const auto &measurements = file["measurements"], &references = file["references"];
  return measurements.is_object() && references.is_array() && std::ranges::all_of(measurements, is_measurement) &&
         std::ranges::all_of(references, is_reference);
}

Json read_measurements(const fs::path& path) {
  std::ifstream file(path);
  if (!file)
    throw InputError({{path.string(), 0}, {}, {}, "this run has not been measured", "tektite postprocess DIR first"});
  auto json = Json::parse(file, nullptr, false);
  if (!is_whole(json))
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
  check_file(run.snapshots.back());
  const auto last = read_fields(run.snapshots.back(), {});
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
