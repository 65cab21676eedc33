#include "postprocess/render/line_chart.hpp"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDoubleArray.h>
#include <vtkPlotPoints.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include "postprocess/render/colours.hpp"
#include "postprocess/render/image.hpp"
#include "postprocess/render/style.hpp"

namespace tektite {
namespace {

vtkSmartPointer<vtkDoubleArray> column(const std::vector<double>& values, const std::string& name) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  for (const double value : values) array->InsertNextValue(value);
  return array;
}

}  // namespace

void draw_line_chart(const LineChart& chart, const std::string& path) {
  const auto view = vtkSmartPointer<vtkContextView>::New();
  view->GetRenderWindow()->SetOffScreenRendering(1);
  view->GetRenderWindow()->SetSize(chart.width, chart.height);
  view->GetRenderWindow()->SetMultiSamples(8);
  view->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
  const auto drawn = vtkSmartPointer<vtkChartXY>::New();
  view->GetScene()->AddItem(drawn);
  style_chart(drawn, chart.title);
  style_axis(drawn->GetAxis(vtkAxis::BOTTOM), chart.x_title);
  style_axis(drawn->GetAxis(vtkAxis::LEFT), chart.y_title);
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
  write_png(view->GetRenderWindow(), path);
}

}  // namespace tektite
