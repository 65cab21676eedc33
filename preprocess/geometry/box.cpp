// box: from the corner `lower` to the corner `upper`.

#include <algorithm>

#include "preprocess/geometry/outline.hpp"
#include "preprocess/geometry/shapes.hpp"

namespace tektite::preprocess {
namespace {

class BoxShape final : public Shape {
 public:
  BoxShape(const Point& lower, const Point& upper) : lower_(lower), upper_(upper) {}

  int dimensions() const override { return 3; }
  bool inside(const Point& x, double tolerance) const override {
    for (int k = 0; k < 3; ++k)
      if (std::max(lower_[k] - x[k], x[k] - upper_[k]) > tolerance) return false;
    return true;
  }
  double reach(const Point& n) const override {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) sum += std::max(n[k] * lower_[k], n[k] * upper_[k]);
    return sum;
  }
  double measure() const override {
    const auto extent = upper_ - lower_;
    return extent[0] * extent[1] * extent[2];
  }
  Surface surface(const Placement& placement) const override { return box_surface(lower_, upper_, placement); }

 private:
  Point lower_, upper_;
};

}  // namespace

ShapePointer read_box(Section& section, int dimensions) {
  const auto [lower, upper] = read_corners(section, dimensions);
  return std::make_unique<BoxShape>(lower, upper);
}

}  // namespace tektite::preprocess
