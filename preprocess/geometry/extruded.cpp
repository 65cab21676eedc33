// extruded: the polygon `points` in the plane of the two coordinates that follow `axis` (z: x and y; x: y and z;
// y: z and x), from `lower` to `upper` along that axis.

#include <algorithm>
#include <array>

#include "preprocess/geometry/outline.hpp"
#include "preprocess/geometry/shapes.hpp"

namespace tektite::preprocess {
namespace {

class Extruded final : public Shape {
 public:
  Extruded(std::vector<PlanePoint> corners, int axis, double lower, double upper)
      : corners_(std::move(corners)), axis_(axis), lower_(lower), upper_(upper) {}

  int dimensions() const override { return 3; }
  bool inside(const Point& x, double tolerance) const override {
    if (std::max(lower_ - x[axis_], x[axis_] - upper_) > tolerance) return false;
    return signed_distance(corners_, x[(axis_ + 1) % 3], x[(axis_ + 2) % 3]) <= tolerance;
  }
  double reach(const Point& n) const override {
    const double nx = n[(axis_ + 1) % 3], ny = n[(axis_ + 2) % 3], nz = n[axis_];
    double most = nx * corners_[0][0] + ny * corners_[0][1];
    for (const auto& corner : corners_) most = std::max(most, nx * corner[0] + ny * corner[1]);
    return most + std::max(nz * lower_, nz * upper_);
  }
  double measure() const override { return area(corners_) * (upper_ - lower_); }
  Surface surface(const Placement& placement) const override {
    return prism_surface(corners_, lower_, upper_, placement.after(from_z()));
  }

 private:
  /// Turns z to the axis of extrusion, and x and y to the two that follow: a third of a turn about (1, 1, 1) a step.
  Placement from_z() const {
    constexpr double third_of_turn = 2.0943951023931954923;
    constexpr double inverse_root_3 = 0.57735026918962576451;
    const Point diagonal{{inverse_root_3, inverse_root_3, inverse_root_3}};
    return Placement::rotation(third_of_turn * ((axis_ + 1) % 3), diagonal, Point{});
  }

  std::vector<PlanePoint> corners_;
  int axis_;
  double lower_, upper_;
};

}  // namespace

ShapePointer read_extruded(Section& section, int) {
  const std::array<std::string, 3> axes{"x", "y", "z"};
  auto corners = read_outline(section);
  const int axis = section.choice("axis", axes, "z").front() - 'x';
  const double lower = section.quantity("lower", dimension::length, limits::any);
  const double upper = section.quantity("upper", dimension::length, limits::any);
  if (upper <= lower) throw section.fault("upper", "must be larger than lower");
  return std::make_unique<Extruded>(std::move(corners), axis, lower, upper);
}

}  // namespace tektite::preprocess
