#include "preprocess/geometry/round.hpp"

#include <cmath>
#include <numbers>

namespace tektite::preprocess {
namespace {

using std::numbers::pi;

Surface ball(const Point& centre, double radius, const Placement& placement) {
  constexpr int arcs = facets_around / 2;
  std::vector<PlanePoint> outline;
  for (int k = 0; k <= arcs; ++k) {
    const double angle = pi * k / arcs;
    outline.push_back({-radius * std::cos(angle), k == 0 || k == arcs ? 0.0 : radius * std::sin(angle)});
  }
  return revolved_surface(outline, 4.0 / 3.0 * pi * radius * radius * radius,
                          placement.after(Placement::translation(centre)));
}

}  // namespace

bool RoundShape::inside(const Point& x, double tolerance) const {
  const double r = norm(x - round_.centre);
  return r <= round_.outer + tolerance && (round_.inner == 0.0 || r >= round_.inner - tolerance);
}

double RoundShape::reach(const Point& direction) const { return dot(round_.centre, direction) + round_.outer; }

double RoundShape::measure() const {
  const auto& [centre, a, b] = round_;
  return dimensions_ == 2 ? pi * (b - a) * (b + a) : 4.0 / 3.0 * pi * (b - a) * (b * b + b * a + a * a);
}

Region RoundShape::region(const Placement& placement) const {
  const auto c = placement.apply(round_.centre);
  const auto outer = Region::disc({c[0], c[1]}, round_.outer);
  return round_.inner == 0.0 ? outer : outer.without(Region::disc({c[0], c[1]}, round_.inner));
}

Surface RoundShape::surface(const Placement& placement) const {
  const auto outer = ball(round_.centre, round_.outer, placement);
  return round_.inner == 0.0 ? outer : outer.without(ball(round_.centre, round_.inner, placement));
}

}  // namespace tektite::preprocess
