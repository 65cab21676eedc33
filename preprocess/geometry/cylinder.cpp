// cylinder: `base`, the middle of its first face; `axis`; `length`; `radius`; `inner_radius` where it is a tube.

#include <algorithm>
#include <numbers>

#include "preprocess/geometry/axial.hpp"
#include "preprocess/geometry/shapes.hpp"

namespace tektite::preprocess {
namespace {

class Cylinder final : public AxialShape {
 public:
  Cylinder(const Axis& axis, double length, double inner, double outer)
      : AxialShape(axis), length_(length), inner_(inner), outer_(outer) {}

  double measure() const override { return std::numbers::pi * (outer_ - inner_) * (outer_ + inner_) * length_; }

 protected:
  bool profile_inside(double axial, double radial, double tolerance) const override {
    if (std::max({-axial, axial - length_, radial - outer_}) > tolerance) return false;
    return inner_ == 0.0 || inner_ - radial <= tolerance;
  }
  double profile_reach(double a, double r) const override { return std::max(0.0, a * length_) + r * outer_; }
  std::vector<PlanePoint> outline() const override {
    return {{0.0, inner_}, {0.0, outer_}, {length_, outer_}, {length_, inner_}};
  }

 private:
  double length_, inner_, outer_;
};

}  // namespace

ShapePointer read_cylinder(Section& section, int) {
  const auto axis = read_axis(section, "base");
  const double length = section.quantity("length", dimension::length, limits::positive);
  const double outer = section.quantity("radius", dimension::length, limits::positive);
  const double inner = section.quantity("inner_radius", dimension::length, limits::not_negative, 0.0);
  if (outer <= inner) throw section.fault("inner_radius", "must be smaller than radius");
  return std::make_unique<Cylinder>(axis, length, inner, outer);
}

}  // namespace tektite::preprocess
