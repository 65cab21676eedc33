#include "postprocess/render/draw.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <sstream>

#include "core/error.hpp"
#include "postprocess/render/chart.hpp"
#include "postprocess/render/display.hpp"
#include "postprocess/render/particle_picture.hpp"
#include "postprocess/render/profile.hpp"

namespace tektite {
namespace {

namespace fs = std::filesystem;
using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

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
void draw_one(const Picture& picture, const Drawing& drawing, const std::function<void(const std::string&)>& tell) {
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

void draw_all(const std::vector<Picture>& pictures, const Drawing& drawing, std::FILE* report) {
  const auto tell = [&](const std::string& line) {
    std::fputs((line + '\n').c_str(), report);
    std::fflush(report);
  };
  try {
    const PrivateDisplay display;
    for (const auto& picture : pictures) try {
        draw_one(picture, drawing, tell);
      } catch (const std::exception& fault) {
        tell(fmt::format("warning: no picture {}: {}", picture.name, fault.what()));
      }
  } catch (const std::exception& fault) {
    tell(fmt::format("warning: no pictures: {}; numbers and ParaView files are written", fault.what()));
  }
}

/// The text of a temporary file, line by line.
std::vector<std::string> lines_of(std::FILE* file) {
  std::rewind(file);
  std::string text;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text.push_back(static_cast<char>(c));
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// What a child that draws has told, and what it complained of where it ended early.
struct Told {
  std::vector<std::string> lines;
  std::optional<std::string> complaint;
};

Told draw_in_child(const std::vector<Picture>& pictures, const Drawing& drawing) {
  const File report(std::tmpfile(), std::fclose);
  const File complaints(std::tmpfile(), std::fclose);
  if (!report || !complaints) return {{"warning: no pictures: no temporary file can be made"}, std::nullopt};
  std::cout.flush();
  const auto child = fork();
  if (child < 0) return {{"warning: no pictures: no process can be started"}, std::nullopt};
  if (child == 0) {
    dup2(fileno(complaints.get()), STDERR_FILENO);
    draw_all(pictures, drawing, report.get());
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  Told told{lines_of(report.get()), std::nullopt};
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return told;
  const auto said = lines_of(complaints.get());
  told.complaint = said.empty() ? std::string() : ": " + said.front();
  return told;
}

}  // namespace

std::vector<std::string> draw_pictures(const std::vector<Picture>& pictures, const Drawing& drawing) {
  // Where several programs draw at once, one may lose its X server to another's that ends: a second try finds a new
  // one.
  auto told = draw_in_child(pictures, drawing);
  if (told.complaint) told = draw_in_child(pictures, drawing);
  if (told.complaint)
    told.lines.push_back("warning: the drawing ended early" + *told.complaint +
                         "; numbers and ParaView files are written");
  return told.lines;
}

}  // namespace tektite
