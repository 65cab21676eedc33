// rectangle: from the corner `lower` to the corner `upper`.

#include <algorithm>
#include <cmath>

#include "preprocess/geometry/outline.hpp"
#include "preprocess/geometry/shapes.hpp"

namespace tektite::preprocess {
namespace {

class Rectangle final : public Shape {
 public:
  Rectangle(const Point& lower, const Point& upper) : lower_(lower), upper_(upper) {}

  int dimensions() const override { return 2; }
  bool inside(const Point& x, double tolerance) const override {
    return std::max({lower_[0] - x[0], x[0] - upper_[0], lower_[1] - x[1], x[1] - upper_[1]}) <= tolerance;
  }
  double reach(const Point& n) const override {
    return std::max(n[0] * lower_[0], n[0] * upper_[0]) + std::max(n[1] * lower_[1], n[1] * upper_[1]);
  }
  double measure() const override { return (upper_[0] - lower_[0]) * (upper_[1] - lower_[1]); }
  Region region(const Placement& placement) const override {
    return Region::polygon(moved(
        {{lower_[0], lower_[1]}, {upper_[0], lower_[1]}, {upper_[0], upper_[1]}, {lower_[0], upper_[1]}}, placement));
  }

 private:
  Point lower_, upper_;
};

}  // namespace

ShapePointer read_rectangle(Section& section, int dimensions) {
  const auto [lower, upper] = read_corners(section, dimensions);
  return std::make_unique<Rectangle>(lower, upper);
}

}  // namespace tektite::preprocess
