// polygon: a simple polygon through `points`. Holes come with the boolean `difference`.

#include <algorithm>

#include "preprocess/geometry/outline.hpp"
#include "preprocess/geometry/shapes.hpp"

namespace tektite::preprocess {
namespace {

class Polygon final : public Shape {
 public:
  explicit Polygon(std::vector<PlanePoint> corners) : corners_(std::move(corners)) {}

  int dimensions() const override { return 2; }
  bool inside(const Point& x, double tolerance) const override {
    return signed_distance(corners_, x[0], x[1]) <= tolerance;
  }
  double reach(const Point& n) const override {
    double most = n[0] * corners_[0][0] + n[1] * corners_[0][1];
    for (const auto& corner : corners_) most = std::max(most, n[0] * corner[0] + n[1] * corner[1]);
    return most;
  }
  double measure() const override { return area(corners_); }
  Region region(const Placement& placement) const override { return Region::polygon(moved(corners_, placement)); }

 private:
  std::vector<PlanePoint> corners_;
};

}  // namespace

ShapePointer read_polygon(Section& section, int) { return std::make_unique<Polygon>(read_outline(section)); }

}  // namespace tektite::preprocess
