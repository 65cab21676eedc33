#include "core/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/plain_name.hpp"

namespace tektite {
namespace {

struct Resolution {
  double factor = 1.0;
  std::vector<std::string> settings;
};

std::vector<Resolution> read_resolutions(Section& section) {
  std::vector<Resolution> resolutions;
  for (auto& entry : section.list("resolutions")) {
    const double factor = entry.quantity("factor", dimension::none, limits::positive);
    for (const auto& other : resolutions)
      if (other.factor == factor) throw entry.fault("factor", "stands twice", "a factor for each resolution");
    resolutions.push_back({factor, entry.texts("set", {})});
    entry.finish();
  }
  std::ranges::sort(resolutions, std::greater{}, &Resolution::factor);
  return resolutions;
}

/// Lays the spacing times the factor over the member's scene, and over bodies that have one of their own.
void scale_spacing(Member& member) {
  auto document = member.load();
  auto root = document.root();
  member.spacing = member.factor * root.quantity("spacing", dimension::length, limits::positive);
  member.settings.push_back(fmt::format("spacing={}", member.spacing));
  for (auto& [name, body] : root.named_sections("body")) {
    if (body.has_table("arrangement") && body.section("arrangement").has("count"))
      throw body.section("arrangement").fault("count", "a study refines by the spacing", "a scene without count");
    if (!body.has("spacing")) continue;
    const double own = body.quantity("spacing", dimension::length, limits::positive);
    member.settings.push_back(fmt::format("body.{}.spacing={}", name, member.factor * own));
  }
}

std::string path_beside(const Section& section, const std::string& path) {
  return (std::filesystem::path(section.origin()).parent_path() / path).lexically_normal().string();
}

void append(std::vector<std::string>& settings, const std::vector<std::string>& more) {
  settings.insert(settings.end(), more.begin(), more.end());
}

}  // namespace

Study read_study(Section& root) {
  Study study;
  study.name = root.text("name");
  if (!is_plain_name(study.name)) throw root.fault("name", "names files, so it must be plain", plain_characters);
  study.title = root.text("title", study.name);
  const auto scene = root.has("scene") ? root.text("scene") : std::string();
  const auto settings = root.texts("set", {});
  const auto resolutions = root.has("resolutions") ? read_resolutions(root) : std::vector<Resolution>();
  constexpr std::array<std::string_view, 3> of_postprocess{"error", "combine", "target"};
  root.leave(of_postprocess);

  for (auto& [name, section] : root.named_sections("line")) {
    if (!is_plain_name(name)) throw section.fault("", "names files, so it must be plain", plain_characters);
    StudyLine line{name, section.text("title", name), {}};
    const auto own_scene = section.has("scene") || scene.empty() ? section.text("scene") : scene;
    const auto variant = section.text("variant", "");
    const auto own_settings = section.texts("set", {});
    const auto own_resolutions =
        section.has("resolutions") || resolutions.empty() ? read_resolutions(section) : resolutions;
    section.finish();
    for (const auto& resolution : own_resolutions) {
      Member member{fmt::format("{}-{}", name, resolution.factor),
                    resolution.factor,
                    0.0,
                    path_beside(root, own_scene),
                    variant,
                    settings};
      append(member.settings, own_settings);
      append(member.settings, resolution.settings);
      scale_spacing(member);
      line.members.push_back(member);
    }
    study.lines.push_back(line);
  }
  if (study.lines.empty()) throw root.fault("line", "there is nothing to run", "[line.NAME]");
  return study;
}

}  // namespace tektite
