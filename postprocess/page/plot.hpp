#pragma once
// Curves over time as inline SVG, which takes its colours from the page.

#include <string>
#include <vector>

namespace tektite {

struct Curve {
  std::string label;
  std::vector<double> values;  ///< one a time, in SI
};

struct Plot {
  std::string title;
  std::string si_unit;
  std::vector<double> times;  ///< in s
  std::vector<Curve> curves;
  double least = 0.0, most = 0.0, last = 0.0;  ///< the ranges of the axes, in SI
};

/// The plot as an <svg> element with axes, numbers at their ends, and a legend below.
std::string svg_of(const Plot& plot);

}  // namespace tektite
