#pragma once
// Numbers over two axes as coloured cells, several maps beside each other on one page with one scale.

#include <string>
#include <vector>

namespace tektite {

struct HeatPanel {
  std::string title;
  std::vector<double> x, y;    ///< centres of the cells, rising and evenly spaced
  std::vector<double> values;  ///< x by x: value of (i, j) at i * y.size() + j; nan: none
  std::vector<std::vector<double>> across,
      along;  ///< dashed lines x = c and y = c, each {c, from, to} on the other axis
};

struct HeatMap {
  std::string title, x_title, y_title, value_title;
  double largest = 1.0;  ///< of the scale, which begins at zero; what is beyond has its last colour
  double level = 0.0;    ///< values up to here are left white
  std::vector<HeatPanel> panels;
};

/// Draws to a PNG file. Needs an X server.
void draw_heat_map(const HeatMap& map, const std::string& path);

}  // namespace tektite
