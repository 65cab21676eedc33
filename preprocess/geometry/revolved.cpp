// revolved: the polygon `points` of (axial, radial) pairs, turned about `axis` through the point `base`.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "preprocess/geometry/axial.hpp"
#include "preprocess/geometry/outline.hpp"
#include "preprocess/geometry/shapes.hpp"

namespace tektite::preprocess {
namespace {

class Revolved final : public AxialShape {
 public:
  Revolved(const Axis& axis, std::vector<PlanePoint> corners) : AxialShape(axis), corners_(std::move(corners)) {}

  /// Pappus and Guldin: 2π ∫ r dA over the polygon, as a sum over its edges.
  double measure() const override {
    double sum = 0.0;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const auto& [x, r] = corners_[k];
      const auto& [x_next, r_next] = corners_[(k + 1) % corners_.size()];
      sum += (x_next - x) * (r * r + r * r_next + r_next * r_next);
    }
    return std::numbers::pi / 3.0 * std::abs(sum);
  }

 protected:
  bool profile_inside(double axial, double radial, double tolerance) const override {
    // On the axis itself the distance to an edge along the axis is zero, which a shrunk shape would exclude: look from
    // a little off the axis, where the sign is that of the solid.
    return signed_distance(corners_, axial, std::max(radial, 2.0 * std::abs(tolerance))) <= tolerance;
  }
  double profile_reach(double a, double r) const override {
    double most = a * corners_[0][0] + r * corners_[0][1];
    for (const auto& corner : corners_) most = std::max(most, a * corner[0] + r * corner[1]);
    return most;
  }
  std::vector<PlanePoint> outline() const override { return corners_; }

 private:
  std::vector<PlanePoint> corners_;
};

}  // namespace

ShapePointer read_revolved(Section& section, int) {
  const auto axis = read_axis(section, "base");
  auto corners = read_outline(section);
  for (const auto& corner : corners)
    if (corner[1] < 0.0) throw section.fault("points", "a radial coordinate is negative", "[axial, radial >= 0]");
  return std::make_unique<Revolved>(axis, std::move(corners));
}

}  // namespace tektite::preprocess
