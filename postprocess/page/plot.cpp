#include "postprocess/page/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

#include "postprocess/page/html.hpp"
#include "postprocess/render/colours.hpp"
#include "postprocess/shown_unit.hpp"

namespace tektite {
namespace {

// In the units of the drawing, which the page scales to its width.
constexpr double width = 640.0, left = 70.0, right = 10.0, top = 30.0, height = 240.0, line_height = 20.0;
constexpr std::size_t most_bins = 600;  // of a curve: about one a pixel

struct Frame {
  double least, most, last;
  double x(double time) const { return left + (width - left - right) * (last > 0.0 ? time / last : 0.0); }
  double y(double value) const { return top + height * (most > least ? (most - value) / (most - least) : 0.5); }
};

std::string colour(std::size_t k) {
  const auto& [red, green, blue] = distinct_colour(k);
  return fmt::format("rgb({:.0f},{:.0f},{:.0f})", 255 * red, 255 * green, 255 * blue);
}

/// Of every n points the least and the largest, in their order, and of all the first and the last: no peak is lost.
std::string points_of(const Plot& plot, const Curve& curve, const Frame& frame) {
  const auto count = std::min(plot.times.size(), curve.values.size());
  const auto stride = count / most_bins + 1;
  std::set<std::size_t> drawn;
  if (count > 0) drawn = {0, count - 1};
  for (std::size_t first = 0; first < count; first += stride) {
    const auto begin = curve.values.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min(stride, count - first));
    for (const auto extreme : {std::min_element(begin, end), std::max_element(begin, end)})
      drawn.insert(static_cast<std::size_t>(extreme - curve.values.begin()));
  }
  std::string points;
  for (const auto k : drawn) points += fmt::format("{:.1f},{:.1f} ", frame.x(plot.times[k]), frame.y(curve.values[k]));
  return points;
}

std::string text(double x, double y, const std::string& anchor, const std::string& words) {
  return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, escaped(words));
}

std::string axes(const Plot& plot, const Frame& frame) {
  const auto unit = shown_unit(std::max(std::abs(plot.least), std::abs(plot.most)), plot.si_unit);
  const auto time = shown_unit(plot.last, "s");
  const double bottom = top + height;
  auto drawing = fmt::format("<path class=\"axis\" d=\"M{0},{1} V{2} H{3}\"/>\n", left, top, bottom, width - right);
  if (plot.least < 0.0 && plot.most > 0.0)
    drawing += fmt::format("<path class=\"zero\" d=\"M{},{:.1f} H{}\"/>\n", left, frame.y(0.0), width - right);
  drawing += text(left - 5, top + 10, "end", fmt::format("{:.3g}", plot.most * unit.factor));
  drawing += text(left - 5, bottom, "end", fmt::format("{:.3g}", plot.least * unit.factor));
  drawing += text(left, bottom + 18, "middle", "0");
  drawing += text(width - right, bottom + 18, "end", fmt::format("{:.4g} {}", plot.last * time.factor, time.label));
  return drawing + text(left, top - 10, "start", unit.label.empty() ? plot.title : plot.title + ", " + unit.label);
}

}  // namespace

std::string svg_of(const Plot& plot) {
  const Frame frame{plot.least, plot.most, plot.last};
  const double legend = top + height + 40.0;
  const std::size_t lines = (plot.curves.size() + 1) / 2;
  auto drawing = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n", width,
                             legend + line_height * static_cast<double>(lines), escaped(plot.title));
  drawing += axes(plot, frame);
  for (std::size_t k = 0; k < plot.curves.size(); ++k) {
    drawing += fmt::format("<polyline class=\"curve\" stroke=\"{}\" points=\"{}\"/>\n", colour(k),
                           points_of(plot, plot.curves[k], frame));
    const std::size_t line = k / 2;
    const double x = left + (k % 2 == 0 ? 0.0 : 0.5 * (width - left)),
                 y = legend + line_height * static_cast<double>(line);
    drawing += fmt::format("<path class=\"curve\" stroke=\"{}\" d=\"M{:.0f},{:.0f} h24\"/>\n", colour(k), x, y - 4);
    drawing += text(x + 30, y, "start", plot.curves[k].label);
  }
  return drawing + "</svg>\n";
}

}  // namespace tektite
