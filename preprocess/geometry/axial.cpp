#include "preprocess/geometry/axial.hpp"

namespace tektite::preprocess {
namespace {

/// Turns the x axis to `direction`.
Placement from_x(const Axis& axis) {
  const auto& d = axis.direction;
  const double sine = std::hypot(d[1], d[2]);
  const Point about = sine > 0.0 ? Point{{0.0, -d[2] / sine, d[1] / sine}} : Point{{0.0, 0.0, 1.0}};
  return Placement::translation(axis.base).after(Placement::rotation(std::atan2(sine, d[0]), about, Point{}));
}

}  // namespace

bool AxialShape::inside(const Point& x, double tolerance) const {
  const auto from_base = x - axis_.base;
  const double axial = dot(from_base, axis_.direction);
  return profile_inside(axial, norm(from_base - axial * axis_.direction), tolerance);
}

double AxialShape::reach(const Point& n) const {
  const double along = dot(n, axis_.direction);
  return dot(n, axis_.base) + profile_reach(along, norm(n - along * axis_.direction));
}

Surface AxialShape::surface(const Placement& placement) const {
  return revolved_surface(outline(), measure(), placement.after(from_x(axis_)));
}

Axis read_axis(Section& section, const std::string& base_key) {
  Axis axis;
  axis.base = read_point(section, base_key, 3, Point{});
  axis.direction = read_direction(section, "axis", axis.direction);
  return axis;
}

}  // namespace tektite::preprocess
