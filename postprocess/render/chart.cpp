#include "postprocess/render/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "postprocess/render/line_chart.hpp"
#include "postprocess/render/words.hpp"
#include "postprocess/scalar_field.hpp"
#include "postprocess/shown_unit.hpp"

namespace tektite {
namespace {

/// "centre.velocity_x" belongs to the field velocity.
std::string field_of_column(const std::string& column) {
  auto field = column.substr(column.find('.') + 1);
  const auto& known = scalar_field_names();
  if (field.size() > 2 && field[field.size() - 2] == '_' && std::find(known.begin(), known.end(), field) == known.end())
    field.resize(field.size() - 2);
  return field;
}

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

std::string common_unit(const Picture& picture) {
  const auto unit = unit_of_column(picture.columns.front());
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
  return column == "time" || column == "dt" ? "s" : "1";
}

void draw_history(const Picture& picture, const History& history, const Scene& scene, const std::string& path) {
  const auto si_unit = common_unit(picture);
  const auto& time = history.column("time");
  double most = 0.0;
  for (const auto& column : picture.columns) most = std::max(most, largest(history.column(column)));
  const auto unit = shown_unit(most, si_unit);
  const auto time_unit = shown_unit(largest(time), "s");

  const bool energy = si_unit == "J" || si_unit == "kg m/s";
  const std::string slice = energy && dimensions_of(scene.space) == 2 ? " (per metre of thickness)" : "";
  LineChart chart{fmt::format("{}: {}", scene.title, readable(picture.name)),
                  fmt::format("time, {}", time_unit.label),
                  unit.label + slice,
                  {},
                  picture.width,
                  picture.height};
  for (const auto& column : picture.columns)
    chart.lines.push_back(
        {readable(column), scaled(time, time_unit.factor), scaled(history.column(column), unit.factor)});
  if (!picture.exact.empty()) {
    ChartLine exact{"exact", {}, {}};
    for (const auto& point : picture.exact) {
      exact.x.push_back(point[0] * time_unit.factor);
      exact.y.push_back(point[1] * unit.factor);
    }
    chart.lines.push_back(exact);
  }
  draw_line_chart(chart, path);
}

}  // namespace tektite
