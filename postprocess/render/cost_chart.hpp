#pragma once
// Error against cost, both logarithmic: a line for each line of a study, and the front of the runs that no other beats.

#include <string>
#include <vector>

#include "postprocess/accuracy/cost.hpp"

namespace tektite {

struct CostLine {
  std::string label;
  std::vector<Judged> runs;  ///< coarsest first; may be empty
};

struct CostChart {
  std::string title;
  std::vector<CostLine> lines;
  std::vector<Judged> front;  ///< by rising cost
  double target = 0.01;       ///< drawn as a level where it lies within the errors
};

/// Draws to `path`.svg and `path`.png in a process of its own, and gives a line for each file or the warning why there
/// is none.
std::vector<std::string> draw_cost_chart(const CostChart& chart, const std::string& path);

}  // namespace tektite
