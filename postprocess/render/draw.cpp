#include "postprocess/render/draw.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <mutex>

#include "core/error.hpp"
#include "postprocess/render/chart.hpp"
#include "postprocess/render/particle_picture.hpp"
#include "postprocess/render/profile.hpp"

namespace tektite {
namespace {

namespace fs = std::filesystem;

/// The snapshots that a picture shows.
std::vector<std::string> snapshots_of(const Picture& picture, const Drawing& drawing) {
  const auto& snapshots = drawing.run.snapshots;
  if (picture.all_times) return snapshots;
  if (picture.times.empty()) return {snapshots.back()};
  std::vector<std::string> chosen;
  for (const double wanted : picture.times) chosen.push_back(snapshots[nearest_snapshot(drawing.event, wanted)]);
  return chosen;
}

/// HDF5 is one thread's at a time.
Snapshot read_alone(const std::string& file, const Picture& picture) {
  static std::mutex reading;
  const std::scoped_lock lock(reading);
  return read_fields(file, fields_shown(picture));
}

/// Draws one picture, which is several files where it shows several times; tells each path.
void draw_one(const Picture& picture, const Drawing& drawing, std::vector<std::string>& told) {
  const auto folder = fs::path(drawing.run.path) / "pictures";
  if (picture.type == PictureType::history) {
    if (!drawing.run.history) throw RunError("there is no history.csv");
    const auto path = (folder / (picture.name + ".png")).string();
    draw_history(picture, *drawing.run.history, drawing.scene, path);
    told.push_back("picture: " + path);
    return;
  }
  for (const auto& file : snapshots_of(picture, drawing)) {
    const bool is_last = file == drawing.run.snapshots.back();
    const bool series = picture.all_times || !picture.times.empty();
    const auto name = series ? fmt::format("{}_{}", picture.name, fs::path(file).stem().string()) : picture.name;
    const auto path = (folder / (name + ".png")).string();
    auto* const draw = picture.type == PictureType::profile ? draw_profile : draw_particles;
    if (is_last)
      draw(picture, drawing.event.last_snapshot, drawing, path);
    else
      draw(picture, read_alone(file, picture), drawing, path);
    told.push_back("picture: " + path);
  }
}

}  // namespace

std::vector<std::string> draw_pictures(const std::vector<Picture>& pictures, const Drawing& drawing) {
  std::vector<std::vector<std::string>> told(pictures.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < pictures.size(); ++k) try {
      draw_one(pictures[k], drawing, told[k]);
    } catch (const std::exception& fault) {
      told[k].push_back(fmt::format("warning: no picture {}: {}", pictures[k].name, fault.what()));
    }
  std::vector<std::string> all;
  for (const auto& lines : told) all.insert(all.end(), lines.begin(), lines.end());
  return all;
}

}  // namespace tektite
