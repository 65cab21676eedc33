#pragma once
// All pictures of a run.

#include <string>
#include <vector>

#include "postprocess/plan.hpp"
#include "postprocess/report.hpp"

namespace tektite {

/// What pictures are drawn of.
struct Drawing {
  const RunFolder& run;
  const Scene& scene;
  const Event& event;
  const std::vector<Measurement>& measurements;
};

/// Draws each picture to DIR/pictures/ and returns what is to be told: a path a picture, or why there is none.
std::vector<std::string> draw_pictures(const std::vector<Picture>& pictures, const Drawing& drawing);

}  // namespace tektite
