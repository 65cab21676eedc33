#include "postprocess/render/cost_chart.hpp"

#include <fmt/format.h>
#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkDoubleArray.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkRenderWindow.h>
#include <vtkSVGExporter.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/write_beside.hpp"
#include "postprocess/render/apart.hpp"
#include "postprocess/render/chart_view.hpp"
#include "postprocess/render/colours.hpp"
#include "postprocess/render/image.hpp"

namespace tektite {
namespace {

constexpr int width = 1500, height = 900;
constexpr std::size_t colours = 6;  // that are told apart on white; the lines after them take them again, dashed
constexpr double margin = 0.08;     // of an axis, beyond the runs at either end, in decades at least

/// Costs or errors on an axis, as decimal logarithms.
struct Range {
  double least = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();
  void take(double value) {
    if (!(value > 0.0)) return;
    least = std::min(least, std::log10(value));
    largest = std::max(largest, std::log10(value));
  }
  bool holds(double value) const { return least <= std::log10(value) && std::log10(value) <= largest; }
  void widen() {
    if (least > largest) least = -1.0, largest = 1.0;
    const double more = std::max(margin, margin * (largest - least));
    least -= more;
    largest += more;
  }
};

/// Ticks at 1, 2 and 5 times the powers of ten, at the powers alone where there are many.
void set_ticks(vtkAxis* axis, const Range& range, double factor, const std::string& unit) {
  const auto positions = vtkSmartPointer<vtkDoubleArray>::New();
  const auto labels = vtkSmartPointer<vtkStringArray>::New();
  const bool wide = range.largest - range.least > 3.0;
  for (int power = static_cast<int>(std::floor(range.least)); power <= range.largest; ++power)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double value = digit * std::pow(10.0, power), place = std::log10(value);
      if (place < range.least || place > range.largest || (wide && digit != 1.0)) continue;
      positions->InsertNextValue(place);
      labels->InsertNextValue(fmt::format("{:.4g}{}", factor * value, unit));
    }
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(range.least, range.largest);
  axis->SetCustomTickPositions(positions, labels);
}

vtkSmartPointer<vtkTable> table_of(const std::vector<Judged>& runs, const std::string& label) {
  const auto cost = vtkSmartPointer<vtkDoubleArray>::New(), error = vtkSmartPointer<vtkDoubleArray>::New();
  cost->SetName("cost");
  error->SetName(label.c_str());
  for (const auto& run : runs)
    if (run.cost > 0.0 && run.error > 0.0) {
      cost->InsertNextValue(std::log10(run.cost));
      error->InsertNextValue(std::log10(run.error));
    }
  auto table = vtkSmartPointer<vtkTable>::New();
  table->AddColumn(cost);
  table->AddColumn(error);
  return table;
}

vtkPlotLine* add_line(vtkChartXY* chart, const std::vector<Judged>& runs, const std::string& label) {
  auto* line = vtkPlotLine::SafeDownCast(chart->AddPlot(vtkChart::LINE));
  line->SetInputData(table_of(runs, label), 0, 1);
  return line;
}

/// The front as steps: up to the cost of the next run nothing is better than the run before it.
std::vector<Judged> steps_of(const std::vector<Judged>& front, double end) {
  std::vector<Judged> steps;
  for (std::size_t k = 0; k < front.size(); ++k) {
    steps.push_back(front[k]);
    steps.push_back({k + 1 < front.size() ? front[k + 1].cost : end, front[k].error});
  }
  return steps;
}

void add_lines(vtkChartXY* chart, const CostChart& asked, const Range& costs, const Range& errors) {
  const double first = std::pow(10.0, costs.least), last = std::pow(10.0, costs.largest);
  auto* front = add_line(chart, steps_of(asked.front, last), "Pareto front");
  front->SetColor(190, 190, 190, 255);
  front->SetWidth(9.0F);
  if (errors.holds(asked.target)) {
    auto* level = add_line(chart, {{first, asked.target}, {last, asked.target}},
                           fmt::format("error of {:.3g} %", 100.0 * asked.target));
    level->SetColor(110, 110, 110, 255);
    level->SetWidth(2.0F);
    level->GetPen()->SetLineType(vtkPen::DASH_LINE);
  }
  constexpr std::array<int, 4> markers{vtkPlotPoints::CIRCLE, vtkPlotPoints::SQUARE, vtkPlotPoints::DIAMOND,
                                       vtkPlotPoints::CROSS};
  for (std::size_t k = 0; k < asked.lines.size(); ++k) {
    auto* line = add_line(chart, asked.lines[k].runs, asked.lines[k].label);
    const auto& [red, green, blue] = distinct_colour(k % colours);
    line->SetColor(red, green, blue);
    line->SetWidth(3.0F);
    if (k >= colours) line->GetPen()->SetLineType(vtkPen::DASH_LINE);
    line->SetMarkerStyle(markers[k % markers.size()]);
    line->SetMarkerSize(14.0F);
  }
}

void write_svg(vtkContextView* view, const std::string& path) {
  write_beside(path, [&](const std::string& beside) {
    const auto exporter = vtkSmartPointer<vtkSVGExporter>::New();
    exporter->SetRenderWindow(view->GetRenderWindow());
    exporter->SetFileName(beside.c_str());
    exporter->SetTitle("error against cost");
    exporter->SetTextAsPath(false);
    exporter->Write();
  });
}

void draw(const CostChart& asked, const std::string& path, const Tell& tell) {
  Range costs, errors;
  for (const auto& line : asked.lines)
    for (const auto& run : line.runs) costs.take(run.cost), errors.take(run.error);
  costs.widen();
  errors.widen();

  const auto [view, chart] = make_chart_view(width, height, asked.title, "processor time, s", "error");
  chart->GetLegend()->SetLabelSize(20);
  set_ticks(chart->GetAxis(vtkAxis::BOTTOM), costs, 1.0, "");
  set_ticks(chart->GetAxis(vtkAxis::LEFT), errors, 100.0, " %");
  add_lines(chart, asked, costs, errors);
  write_png(view, path + ".png");
  tell("picture: " + path + ".png");
  write_svg(view, path + ".svg");
  tell("picture: " + path + ".svg");
}

}  // namespace

std::vector<std::string> draw_cost_chart(const CostChart& chart, const std::string& path) {
  return draw_apart([&](const Tell& tell) { draw(chart, path, tell); });
}

}  // namespace tektite
