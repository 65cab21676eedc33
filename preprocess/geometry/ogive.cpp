// ogive: a tangent ogive nose of `nose_length` that begins at the point `tip`, and a cylindrical shank of
// `shank_length` behind it, both of `radius` where they meet; `axis` points from the tip to the base.
//
// The nose is an arc of radius rho = (R² + L²)/(2R) whose centre lies at (L, R - rho) in (axial, radial), so that its
// tangent at the shank is parallel to the axis.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "preprocess/geometry/axial.hpp"
#include "preprocess/geometry/shapes.hpp"

namespace tektite::preprocess {
namespace {

class Ogive final : public AxialShape {
 public:
  Ogive(const Axis& axis, double radius, double nose, double shank)
      : AxialShape(axis),
        radius_(radius),
        nose_(nose),
        shank_(shank),
        arc_((radius * radius + nose * nose) / (2.0 * radius)) {}

  /// π ∫ (√(ρ² − u²) − c)² du over 0 <= u <= L with c = ρ − R, and the shank.
  double measure() const override {
    const double c = arc_ - radius_, l = nose_;
    const double half_disc = 0.5 * (l * c + arc_ * arc_ * std::asin(l / arc_));  // √(ρ² − L²) = c
    const double nose = arc_ * arc_ * l - l * l * l / 3.0 + c * c * l - 2.0 * c * half_disc;
    return std::numbers::pi * (nose + radius_ * radius_ * shank_);
  }

 protected:
  bool profile_inside(double axial, double radial, double tolerance) const override {
    if (std::max(-axial, axial - nose_ - shank_) > tolerance) return false;
    if (axial >= nose_) return radial <= radius_ + tolerance;
    return std::hypot(nose_ - axial, radial + arc_ - radius_) <= arc_ + tolerance;
  }
  double profile_reach(double a, double r) const override {
    const double corners = std::max(0.0, std::max(a * nose_, a * (nose_ + shank_)) + r * radius_);
    const bool on_nose = a <= 0.0 && nose_ + arc_ * a >= 0.0;  // where the arc's normal is (a, r)
    return on_nose ? std::max(corners, a * nose_ + r * (radius_ - arc_) + arc_ * std::hypot(a, r)) : corners;
  }
  std::vector<PlanePoint> outline() const override {
    constexpr int pieces = facets_around / 2;
    const double opening = std::asin(nose_ / arc_);
    std::vector<PlanePoint> points{{0.0, 0.0}};
    for (int k = 1; k < pieces; ++k) {
      const double angle = opening * (1.0 - static_cast<double>(k) / pieces);
      points.push_back({nose_ - arc_ * std::sin(angle), arc_ * std::cos(angle) - (arc_ - radius_)});
    }
    points.push_back({nose_, radius_});
    if (shank_ > 0.0) points.push_back({nose_ + shank_, radius_});
    points.push_back({nose_ + shank_, 0.0});
    return points;
  }

 private:
  double radius_, nose_, shank_, arc_;
};

}  // namespace

ShapePointer read_ogive(Section& section, int) {
  const auto axis = read_axis(section, "tip");
  const double radius = section.quantity("radius", dimension::length, limits::positive);
  const double nose = section.quantity("nose_length", dimension::length, limits::positive);
  if (nose < radius) throw section.fault("nose_length", "a tangent ogive is at least as long as its radius");
  const double shank = section.quantity("shank_length", dimension::length, limits::not_negative, 0.0);
  return std::make_unique<Ogive>(axis, radius, nose, shank);
}

}  // namespace tektite::preprocess
