#include "postprocess/render/places_apart.hpp"

#include <algorithm>
#include <span>

namespace tektite {
namespace {

bool cover(const PictureBox& a, const PictureBox& b) {
  return a.left < b.right && b.left < a.right && a.lower < b.upper && b.lower < a.upper;
}

}  // namespace

std::vector<PictureBox> places_apart(std::vector<PictureBox> boxes) {
  for (std::size_t k = 1; k < boxes.size(); ++k) {
    auto& box = boxes[k];
    const std::span before(boxes.data(), k);
    const auto covered = [&] {
      return std::ranges::find_if(before, [&](const PictureBox& b) { return cover(b, box); });
    };
    for (auto other = covered(); other != before.end(); other = covered()) {
      box.lower = other->lower - (box.upper - box.lower);
      box.upper = other->lower;
    }
  }
  return boxes;
}

}  // namespace tektite
