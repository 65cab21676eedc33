#include "postprocess/render/draw.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "core/error.hpp"
#include "postprocess/render/apart.hpp"
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

/// Draws one picture, which is several files where it shows several times; tells each path.
void draw_one(const Picture& picture, const Drawing& drawing, ParticlePictures& particles, const Tell& tell) {
  const auto folder = fs::path(drawing.run.path) / "pictures";
  if (picture.type == PictureType::history) {
    if (!drawing.run.history) throw RunError("there is no history.csv");
    const auto path = (folder / (picture.name + ".png")).string();
    draw_history(picture, *drawing.run.history, drawing.scene, path);
    tell("picture: " + path);
    return;
  }
  for (const auto& file : snapshots_of(picture, drawing)) {
    const bool is_last = file == drawing.run.snapshots.back();
    const bool series = picture.all_times || !picture.times.empty();
    const auto name = series ? fmt::format("{}_{}", picture.name, fs::path(file).stem().string()) : picture.name;
    const auto path = (folder / (name + ".png")).string();
    const auto draw = [&](const Snapshot& snapshot) {
      if (picture.type == PictureType::profile)
        draw_profile(picture, snapshot, drawing, path);
      else
        particles.draw(picture, snapshot, drawing, path);
    };
    if (is_last)
      draw(drawing.event.last_snapshot);
    else
      draw(read_snapshot(file));
    tell("picture: " + path);
  }
}

}  // namespace

std::vector<std::string> draw_pictures(const std::vector<Picture>& pictures, const Drawing& drawing) {
  return draw_apart([&](const Tell& tell) {
    ParticlePictures particles;
    for (const auto& picture : pictures) try {
        draw_one(picture, drawing, particles, tell);
      } catch (const std::exception& fault) {
        tell(fmt::format("warning: no picture {}: {}", picture.name, fault.what()));
      }
  });
}

}  // namespace tektite
