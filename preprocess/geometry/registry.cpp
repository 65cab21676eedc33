#include "preprocess/geometry/registry.hpp"

#include <fmt/format.h>

#include <array>

#include "preprocess/geometry/shapes.hpp"

namespace tektite::preprocess {
namespace {

struct ShapeRow {
  const char* name;
  int least_dimensions;
  int most_dimensions;
  ShapePointer (*read)(Section&, int);
};

constexpr std::array<ShapeRow, 15> shapes{{
    {"segment", 1, 1, read_segment},
    {"rectangle", 2, 2, read_rectangle},
    {"disc", 2, 2, read_disc},
    {"ring", 2, 2, read_ring},
    {"polygon", 2, 2, read_polygon},
    {"box", 3, 3, read_box},
    {"sphere", 3, 3, read_sphere},
    {"cylinder", 3, 3, read_cylinder},
    {"ogive", 3, 3, read_ogive},
    {"revolved", 3, 3, read_revolved},
    {"extruded", 3, 3, read_extruded},
    {"mesh", 3, 3, read_mesh},
    {"union", 2, 3, read_union},
    {"difference", 2, 3, read_difference},
    {"intersection", 2, 3, read_intersection},
}};

bool fits(const ShapeRow& row, int dimensions) {
  return row.least_dimensions <= dimensions && dimensions <= row.most_dimensions;
}

}  // namespace

ShapePointer read_shape(Section section, int dimensions) {
  std::vector<std::string> allowed;
  for (const auto& row : shapes)
    if (fits(row, dimensions)) allowed.emplace_back(row.name);
  const auto type = section.has("type") ? section.text("type") : section.choice("type", allowed);
  for (const auto& row : shapes) {
    if (row.name != type) continue;
    if (!fits(row, dimensions))
      throw section.fault("type", fmt::format("a {} has no place in a space of {} dimensions", type, dimensions),
                          join(allowed));
    auto shape = row.read(section, dimensions);
    const auto placement = read_placement(section, dimensions);
    section.finish();
    return placed(std::move(shape), placement);
  }
  throw section.fault("type", "unknown shape", join(allowed));
}

}  // namespace tektite::preprocess
