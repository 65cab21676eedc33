#include "postprocess/render/chart.hpp"

#include <fmt/format.h>
#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDoubleArray.h>
#include <vtkPlot.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "postprocess/render/colours.hpp"
#include "postprocess/render/image.hpp"
#include "postprocess/render/style.hpp"
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

vtkSmartPointer<vtkDoubleArray> scaled(const std::vector<double>& values, double factor, const std::string& name) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  for (const double value : values) array->InsertNextValue(value * factor);
  return array;
}

std::string readable(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
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

  const auto table = vtkSmartPointer<vtkTable>::New();
  table->AddColumn(scaled(time, time_unit.factor, "time"));
  for (const auto& column : picture.columns)
    table->AddColumn(scaled(history.column(column), unit.factor, readable(column)));

  const auto view = vtkSmartPointer<vtkContextView>::New();
  view->GetRenderWindow()->SetOffScreenRendering(1);
  view->GetRenderWindow()->SetSize(picture.width, picture.height);
  view->GetRenderWindow()->SetMultiSamples(8);
  view->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
  const auto chart = vtkSmartPointer<vtkChartXY>::New();
  view->GetScene()->AddItem(chart);
  style_chart(chart, fmt::format("{}: {}", scene.title, readable(picture.name)));
  const bool energy = si_unit == "J" || si_unit == "kg m/s";
  const std::string slice = energy && dimensions_of(scene.space) == 2 ? " (per metre of thickness)" : "";
  style_axis(chart->GetAxis(vtkAxis::BOTTOM), fmt::format("time, {}", time_unit.label));
  style_axis(chart->GetAxis(vtkAxis::LEFT), unit.label + slice);
  for (std::size_t k = 0; k < picture.columns.size(); ++k) {
    auto* line = chart->AddPlot(vtkChart::LINE);
    line->SetInputData(table, 0, static_cast<vtkIdType>(k + 1));
    const auto& [red, green, blue] = distinct_colour(k);
    line->SetColor(red, green, blue);
    line->SetWidth(3.0F);
  }
  write_png(view->GetRenderWindow(), path);
}

}  // namespace tektite
