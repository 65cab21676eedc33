#include "core/stability_study.hpp"

#include <filesystem>

#include "core/plain_name.hpp"

namespace tektite {
namespace {

/// { least, largest, count }: evenly spaced.
std::vector<double> read_range(Section section, const Dimension& dimension, const Limits& limits) {
  const double least = section.quantity("least", dimension, limits);
  const double largest = section.quantity("largest", dimension, limits);
  if (largest <= least) throw section.fault("largest", "is not above least", "a larger value");
  const auto count = section.integer("count", {2.0, 1000.0});
  section.finish();
  std::vector<double> values;
  for (std::int64_t k = 0; k < count; ++k)
    values.push_back(least + (largest - least) * static_cast<double>(k) / static_cast<double>(count - 1));
  return values;
}

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace

StabilityStudy read_stability_study(Section& root) {
  constexpr Limits ratio_limits{0.5, 5.0};  // as of smoothing.ratio in a scene
  StabilityStudy study;
  study.name = root.text("name");
  if (!is_plain_name(study.name)) throw root.fault("name", "names files, so it must be plain", plain_characters);
  study.title = root.text("title", study.name);
  study.stresses = read_range(root.section("stress"), dimension::pressure, limits::any);
  study.ratios = read_range(root.section("ratio"), dimension::none, ratio_limits);
  study.waves = static_cast<int>(root.integer("waves", {1.0, 100.0}, 8));
  auto shown = root.section("shown");
  study.shown_stress = shown.quantity("stress", dimension::pressure);
  study.shown_ratio = shown.quantity("ratio", dimension::none, ratio_limits);
  shown.finish();
  const auto scene = root.has("scene") ? root.text("scene") : std::string();
  const auto material = root.text("material", "");
  const auto settings = root.texts("set", {});
  const auto folder = std::filesystem::path(root.origin()).parent_path();
  for (auto& [name, section] : root.named_sections("line")) {
    if (!is_plain_name(name)) throw section.fault("", "names columns, so it must be plain", plain_characters);
    const auto own_scene = section.has("scene") || scene.empty() ? section.text("scene") : scene;
    study.lines.push_back({name, section.text("title", name), (folder / own_scene).lexically_normal().string(),
                           section.text("variant", ""), joined(settings, section.texts("set", {})),
                           section.text("material", material)});
    section.finish();
  }
  if (study.lines.empty()) throw root.fault("line", "there is nothing to analyse", "[line.NAME]");
  return study;
}

}  // namespace tektite
