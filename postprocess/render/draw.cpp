#include "postprocess/render/draw.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "core/error.hpp"
#include "postprocess/render/apart.hpp"
#include "postprocess/render/chart.hpp"
#include "postprocess/render/particle_picture.hpp"
#include "postprocess/render/profile.hpp"

namespace tektite {
namespace {

namespace fs = std::filesystem;

/// The snapshots that a picture shows, with the time of each.
std::vector<std::string> snapshots_of(const Picture& picture, const RunFolder& run) {
  if (picture.all_times) return run.snapshots;
  if (picture.times.empty()) return {run.snapshots.back()};
  std::vector<double> recorded;
  for (const auto& path : run.snapshots) recorded.push_back(read_snapshot(path).time());
  std::vector<std::string> chosen;
  for (const double wanted : picture.times) {
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < recorded.size(); ++k)
      if (std::abs(recorded[k] - wanted) < std::abs(recorded[nearest] - wanted)) nearest = k;
    chosen.push_back(run.snapshots[nearest]);
  }
  return chosen;
}

/// Draws one picture, which is several files where it shows several times; tells each path.
void draw_one(const Picture& picture, const Drawing& drawing, const Tell& tell) {
  const auto folder = fs::path(drawing.run.path) / "pictures";
  if (picture.type == PictureType::history) {
    if (!drawing.run.history) throw RunError("there is no history.csv");
    const auto path = (folder / (picture.name + ".png")).string();
    draw_history(picture, *drawing.run.history, drawing.scene, path);
    tell("picture: " + path);
    return;
  }
  for (const auto& file : snapshots_of(picture, drawing.run)) {
    const bool is_last = file == drawing.run.snapshots.back();
    const bool series = picture.all_times || !picture.times.empty();
    const auto name = series ? fmt::format("{}_{}", picture.name, fs::path(file).stem().string()) : picture.name;
    const auto path = (folder / (name + ".png")).string();
    const auto draw = picture.type == PictureType::profile ? draw_profile : draw_particles;
    if (is_last)
      draw(picture, drawing.event.last_snapshot, drawing, path);
    else
      draw(picture, read_snapshot(file), drawing, path);
    tell("picture: " + path);
  }
}

}  // namespace

std::vector<std::string> draw_pictures(const std::vector<Picture>& pictures, const Drawing& drawing) {
  return draw_apart([&](const Tell& tell) {
    for (const auto& picture : pictures) try {
        draw_one(picture, drawing, tell);
      } catch (const std::exception& fault) {
        tell(fmt::format("warning: no picture {}: {}", picture.name, fault.what()));
      }
  });
}

}  // namespace tektite
