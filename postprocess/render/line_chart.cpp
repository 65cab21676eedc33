#include "postprocess/render/line_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "postprocess/render/axis.hpp"
#include "postprocess/render/canvas.hpp"
#include "postprocess/render/text.hpp"
#include "postprocess/shown_unit.hpp"

namespace tektite {
namespace {

constexpr Colour black{0.0, 0.0, 0.0};
constexpr Colour light_grey{0.88, 0.88, 0.88};

// In pixels.
constexpr double title_size = 32.0, axis_title_size = 26.0, label_size = 22.0, legend_size = 24.0;
constexpr double gap = 8.0, tick = 6.0, swatch = 26.0, legend_line = 32.0;
constexpr double line_width = 3.0, point_radius = 4.0;
constexpr double room_of_label_x = 75.0, room_of_label_y = 45.0;

/// The axis that all finite numbers of the lines fit on.
Axis axis_of(const std::vector<ChartLine>& lines, std::vector<double> ChartLine::*numbers, double pixels, double room) {
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  for (const auto& line : lines)
    for (const double number : line.*numbers)
      if (std::isfinite(number)) least = std::min(least, number), largest = std::max(largest, number);
  if (least > largest) least = largest = 0.0;
  return tektite::axis_of(least, largest, std::max(4, static_cast<int>(pixels / room)));
}

std::string label(const Axis& axis, int k) { return fmt::format("{:.6g}", without_round_off(axis.tick(k), axis.step)); }

double widest(const std::vector<std::string>& words, double size) {
  double width = 0.0;
  for (const auto& each : words) width = std::max(width, width_of(each, size));
  return width;
}

/// Where the two axes stand on the canvas, and what numbers they carry.
struct Plot {
  Axis x, y;
  double left, right, lower, upper;

  Pixel at(double number_x, double number_y) const {
    return {left + x.share(number_x) * (right - left), lower + y.share(number_y) * (upper - lower)};
  }
};

Plot lay_out(const LineChart& chart, double legend_width) {
  Plot plot;
  plot.lower = 2.0 * gap + axis_title_size + label_size + tick + gap;
  plot.upper = chart.height - 2.0 * gap - title_size;
  plot.y = axis_of(chart.lines, &ChartLine::y, plot.upper - plot.lower, room_of_label_y);
  std::vector<std::string> labels;
  for (int k = 0; k <= plot.y.steps; ++k) labels.push_back(label(plot.y, k));
  plot.left = 2.0 * gap + axis_title_size + widest(labels, label_size) + tick + gap;
  plot.right = std::max(plot.left + gap, chart.width - legend_width - 4.0 * gap);
  plot.x = axis_of(chart.lines, &ChartLine::x, plot.right - plot.left, room_of_label_x);
  // Axes on whole pixels are sharp.
  for (auto* edge : {&plot.left, &plot.right, &plot.lower, &plot.upper}) *edge = std::round(*edge) + 0.5;
  return plot;
}

void draw_axes(Canvas& canvas, const Plot& plot, const LineChart& chart) {
  std::vector<std::pair<Pixel, Pixel>> grid,
      frame{{{plot.left, plot.lower}, {plot.right, plot.lower}}, {{plot.left, plot.lower}, {plot.left, plot.upper}}};
  for (int k = 0; k <= plot.x.steps; ++k) {
    const double x = std::floor(plot.at(plot.x.tick(k), 0.0).x) + 0.5;
    grid.push_back({{x, plot.lower}, {x, plot.upper}});
    frame.push_back({{x, plot.lower - tick}, {x, plot.lower}});
    write(canvas, label(plot.x, k), {x, plot.lower - tick - 0.5 * gap},
          {.size = label_size, .across = Across::centre, .upwards = Upwards::top});
  }
  for (int k = 0; k <= plot.y.steps; ++k) {
    const double y = std::floor(plot.at(0.0, plot.y.tick(k)).y) + 0.5;
    grid.push_back({{plot.left, y}, {plot.right, y}});
    frame.push_back({{plot.left - tick, y}, {plot.left, y}});
    write(canvas, label(plot.y, k), {plot.left - tick - 0.5 * gap, y},
          {.size = label_size, .across = Across::right, .upwards = Upwards::centre});
  }
  canvas.lines(grid, 1.0, light_grey);
  canvas.lines(frame, 1.0, black);
  const double middle_x = 0.5 * (plot.left + plot.right), middle_y = 0.5 * (plot.lower + plot.upper);
  write(canvas, chart.title, {middle_x, plot.upper + gap}, {.size = title_size, .across = Across::centre});
  write(canvas, chart.x_title, {middle_x, gap}, {.size = axis_title_size, .across = Across::centre});
  write(canvas, chart.y_title, {gap + 0.5 * axis_title_size, middle_y},
        {.size = axis_title_size, .across = Across::centre, .upwards = Upwards::centre, .turned = true});
}

/// A line goes on behind a number that is not finite.
void draw_line(Canvas& canvas, const Plot& plot, const ChartLine& line, const Colour& colour) {
  std::vector<std::pair<Pixel, Pixel>> segments;
  for (std::size_t k = 0; k < line.x.size(); ++k) {
    const auto is_finite = [&](std::size_t n) { return std::isfinite(line.x[n]) && std::isfinite(line.y[n]); };
    if (!is_finite(k)) continue;
    const auto here = plot.at(line.x[k], line.y[k]);
    if (line.points)
      canvas.disc(here, point_radius, colour);
    else if (k > 0 && is_finite(k - 1))
      segments.emplace_back(plot.at(line.x[k - 1], line.y[k - 1]), here);
  }
  canvas.lines(segments, line_width, colour);
}

void draw_legend(Canvas& canvas, const Plot& plot, const std::vector<ChartLine>& lines) {
  const double left = plot.right + gap;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const double y = plot.upper - legend_line * (static_cast<double>(k) + 0.5);
    if (lines[k].points)
      canvas.disc({left + 0.5 * swatch, y}, point_radius, distinct_colour(k));
    else
      canvas.lines({{{left, y}, {left + swatch, y}}}, line_width, distinct_colour(k));
    write(canvas, lines[k].name, {left + swatch + gap, y}, {.size = legend_size, .upwards = Upwards::centre});
  }
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
  std::vector<std::string> names;
  for (const auto& line : chart.lines) names.push_back(line.name);
  Canvas canvas(chart.width, chart.height);
  const auto plot = lay_out(chart, gap + swatch + gap + widest(names, legend_size));
  draw_axes(canvas, plot, chart);
  for (std::size_t k = 0; k < chart.lines.size(); ++k) draw_line(canvas, plot, chart.lines[k], distinct_colour(k));
  draw_legend(canvas, plot, chart.lines);
  canvas.write_png(path);
}

}  // namespace tektite
