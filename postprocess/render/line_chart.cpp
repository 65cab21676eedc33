#include "postprocess/render/line_chart.hpp"

#include <vtkDoubleArray.h>
#include <vtkPlotPoints.h>
#include <vtkRenderWindow.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>

#include "postprocess/render/chart_view.hpp"
#include "postprocess/render/colours.hpp"
#include "postprocess/render/image.hpp"
#include "postprocess/shown_unit.hpp"

namespace tektite {
namespace {

vtkSmartPointer<vtkDoubleArray> column(const std::vector<double>& values, const std::string& name) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  for (const double value : values) array->InsertNextValue(value);
  return array;
}

}  // namespace

ChartLine exact_line(const std::vector<std::vector<double>>& points) {
  ChartLine exact{"exact", {}, {}};
  for (const auto& point : points) {
    exact.x.push_back(point[0]);
    exact.y.push_back(point[1]);
  }
  return exact;
}

std::string show_in_unit(std::vector<ChartLine>& lines, std::vector<double> ChartLine::*numbers,
                         const std::string& si_unit) {
  double most = 0.0;
  for (const auto& line : lines)
    for (const double value : line.*numbers) most = std::max(most, std::abs(value));
  const auto unit = shown_unit(most, si_unit);
  for (auto& line : lines)
    for (double& value : line.*numbers) value *= unit.factor;
  return unit.label;
}

void draw_line_chart(const LineChart& chart, const std::string& path) {
  const auto [view, drawn] = make_chart_view(chart.width, chart.height, chart.title, chart.x_title, chart.y_title);
  for (std::size_t k = 0; k < chart.lines.size(); ++k) {
    const auto& line = chart.lines[k];
    const auto table = vtkSmartPointer<vtkTable>::New();
    table->AddColumn(column(line.x, chart.x_title));
    table->AddColumn(column(line.y, line.name));
    auto* plot = drawn->AddPlot(line.points ? vtkChart::POINTS : vtkChart::LINE);
    plot->SetInputData(table, 0, 1);
    const auto& [red, green, blue] = distinct_colour(k);
    plot->SetColor(red, green, blue);
    plot->SetWidth(3.0F);
    if (auto* points = vtkPlotPoints::SafeDownCast(plot); points && line.points) {
      points->SetMarkerStyle(vtkPlotPoints::CIRCLE);
      points->SetMarkerSize(8.0F);
    }
  }
  write_png(view, path);
}

}  // namespace tektite
