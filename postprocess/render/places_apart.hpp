#pragma once

#include <vector>

namespace tektite {

/// Where something stands on a picture, in pixels; y goes up.
struct PictureBox {
  double left = 0.0, lower = 0.0, right = 0.0, upper = 0.0;
};

/// The boxes in their order, those that would cover one before them moved down until they cover none.
std::vector<PictureBox> places_apart(std::vector<PictureBox> boxes);

}  // namespace tektite
