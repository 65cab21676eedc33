#include "postprocess/render/chart.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "postprocess/render/line_chart.hpp"
#include "postprocess/render/words.hpp"
#include "postprocess/scalar_field.hpp"

namespace tektite {
namespace {

/// "centre.velocity_x" belongs to the field velocity, "centre.deviatoric_stress_xy" to deviatoric_stress.
std::string field_of_column(const std::string& column) {
  auto field = column.substr(column.find('.') + 1);
  const auto suffix = field.rfind('_');
  if (field_named(field) || suffix == std::string::npos || field.find_first_not_of("xyz", suffix + 1) != field.npos)
    return field;
  return field.substr(0, suffix);
}

std::string common_unit(const Picture& picture) {
  auto unit = unit_of_column(picture.columns.front());
  for (const auto& column : picture.columns)
    if (unit_of_column(column) != unit)
      throw RunError(fmt::format("{} is in {} and {} in {}: they need a picture each", picture.columns.front(), unit,
                                 column, unit_of_column(column)));
  return unit;
}

}  // namespace

std::string unit_of_column(const std::string& column) {
  if (column.find('.') != std::string::npos) return scalar_field_unit(field_of_column(column));
  if (column.ends_with("_energy") || column.ends_with("_work")) return "J";
  if (column.starts_with("momentum")) return "kg m/s";
  if (column.starts_with("angular_momentum")) return "kg m2/s";
  return column == "time" || column == "dt" ? "s" : "1";
}

std::string slice_of(const std::string& si_unit, Space space) {
  const bool of_all = si_unit == "J" || si_unit == "kg m/s" || si_unit == "kg m2/s";
  return of_all && is_plane(space) ? " (per metre of thickness)" : "";
}

void draw_history(const Picture& picture, const History& history, const Scene& scene, const std::string& path) {
  const auto si_unit = common_unit(picture);
  std::vector<ChartLine> lines;
  for (const auto& column : picture.columns)
    lines.push_back({readable(column), history.column("time"), history.column(column)});
  if (!picture.exact.empty()) lines.push_back(exact_line(picture.exact));
  const auto time_unit = show_in_unit(lines, &ChartLine::x, "s");
  const auto unit = show_in_unit(lines, &ChartLine::y, si_unit);
  draw_line_chart({fmt::format("{}: {}", scene.title, readable(picture.name)), "time, " + time_unit,
                   unit + slice_of(si_unit, scene.space), lines, picture.width, picture.height},
                  path);
}

}  // namespace tektite
