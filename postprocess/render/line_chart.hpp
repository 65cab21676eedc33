#pragma once
// Numbers over numbers, as lines or points.

#include <string>
#include <vector>

namespace tektite {

struct ChartLine {
  std::string name;
  std::vector<double> x, y;
  bool points = false;  ///< drawn as points, in no order
};

/// An exact curve through points [abscissa, value].
ChartLine exact_line(const std::vector<std::vector<double>>& points);

/// Brings the numbers of all lines from SI into the unit that suits the largest of them, and gives its label.
std::string show_in_unit(std::vector<ChartLine>& lines, std::vector<double> ChartLine::*numbers,
                         const std::string& si_unit);

struct LineChart {
  std::string title;
  std::string x_title, y_title;
  std::vector<ChartLine> lines;
  int width = 1600, height = 1000;  ///< in pixels
};

/// Draws it to a PNG file, with a legend beside the lines, not over them. Throws RunError.
void draw_line_chart(const LineChart& chart, const std::string& path);

}  // namespace tektite
