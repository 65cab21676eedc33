#include "core/scene.hpp"

#include <array>

#include "core/plain_name.hpp"

namespace tektite {
namespace {

struct OwnedKey {
  std::string_view table;  ///< "" for the top level, "body" for [body.NAME], "material" for [material.NAME]
  std::string_view key;
  Stage owner;
};

constexpr std::array<OwnedKey, 24> owned_keys{{
    {"", "body", Stage::preprocess},
    {"", "material", Stage::preprocess},
    {"", "material", Stage::solve},
    {"", "body", Stage::solve},
    {"", "spacing", Stage::preprocess},
    {"", "scheme", Stage::solve},
    {"", "viscosity", Stage::solve},
    {"", "contact", Stage::solve},
    {"", "anvil", Stage::solve},
    {"", "time", Stage::solve},
    {"", "output", Stage::solve},
    {"", "probe", Stage::solve},
    {"", "stop_when", Stage::solve},
    {"", "measure", Stage::postprocess},
    {"", "picture", Stage::postprocess},
    {"body", "shape", Stage::preprocess},
    {"body", "arrangement", Stage::preprocess},
    {"body", "spacing", Stage::preprocess},
    {"body", "velocity", Stage::preprocess},
    {"body", "region", Stage::preprocess},
    {"material", "eos", Stage::solve},
    {"material", "strength", Stage::solve},
    {"material", "damage", Stage::solve},
    {"material", "spall_pressure", Stage::solve},
}};

bool owned_by(std::string_view table, std::string_view key, Stage stage) {
  for (const auto& row : owned_keys)
    if (row.table == table && row.key == key && row.owner == stage) return true;
  return false;
}

void leave(Section& section, std::string_view table, Stage stage) {
  for (const auto& row : owned_keys)
    if (row.table == table && !owned_by(table, row.key, stage)) section.leave({&row.key, 1});
}

std::vector<std::string> space_choices() {
  std::vector<std::string> names;
  for (const auto& entry : space_names) names.emplace_back(entry.name);
  return names;
}

}  // namespace

int axis_named(Section& section, const std::string& key, Space space) {
  std::vector<std::string> names;
  for (int k = 0; k < dimensions_of(space); ++k) names.push_back(std::string(1, static_cast<char>('x' + k)));
  return section.choice(key, names).front() - 'x';
}

Scene read_scene(Section& root, Stage stage) {
  Scene scene;
  scene.name = root.text("name");
  if (!is_plain_name(scene.name)) throw root.fault("name", "names files, so it must be plain", plain_characters);
  scene.title = root.text("title", scene.name);
  const auto space = root.choice("space", space_choices());
  for (const auto& entry : space_names)
    if (entry.name == space) scene.space = entry.space;

  auto smoothing = root.section_or_empty("smoothing");
  scene.smoothing_ratio = smoothing.quantity("ratio", dimension::none, {0.5, 5.0}, 1.4);
  scene.kernel = smoothing.text("kernel", "cubic-spline");
  smoothing.finish();

  for (auto& [name, plane] : root.named_sections("symmetry")) {
    const int axis = axis_named(plane, "axis", scene.space);
    if (axis == 0 && hoops_of(scene.space) > 0)
      throw plane.fault("axis", "the radius is measured from the axis: no other plane can lie across it");
    for (const auto& other : scene.symmetry)
      if (other.axis == axis) throw plane.fault("axis", "there is a symmetry plane across this axis already");
    const double at = plane.quantity("at", dimension::length, limits::any, 0.0);
    const std::array<std::string, 2> sides{"above", "below"};
    const double side = plane.choice("keep", sides, "above") == "above" ? 1.0 : -1.0;
    scene.symmetry.push_back({axis, at, side});
    plane.finish();
  }
  if (hoops_of(scene.space) > 0) scene.symmetry.push_back({0, 0.0, 1.0});
  leave(root, "", stage);
  return scene;
}

void leave_others(Section& section, Stage stage) {
  leave(section, section.path().substr(0, section.path().find('.')), stage);
}

}  // namespace tektite
