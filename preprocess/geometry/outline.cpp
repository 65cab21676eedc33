#include "preprocess/geometry/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tektite::preprocess {

double signed_distance(const std::vector<PlanePoint>& corners, double x, double y) {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& a = corners[k];
    const auto& b = corners[(k + 1) % corners.size()];
    const double ux = b[0] - a[0], uy = b[1] - a[1];
    const double along = std::clamp(((x - a[0]) * ux + (y - a[1]) * uy) / (ux * ux + uy * uy), 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(x - a[0] - along * ux, y - a[1] - along * uy));
    const bool crosses = (a[1] > y) != (b[1] > y);
    if (crosses && x < a[0] + (y - a[1]) / uy * ux) inside = !inside;
  }
  return inside ? -nearest : nearest;
}

double area(const std::vector<PlanePoint>& corners) {
  double twice = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& a = corners[k];
    const auto& b = corners[(k + 1) % corners.size()];
    twice += (a[0] - corners[0][0]) * (b[1] - corners[0][1]) - (b[0] - corners[0][0]) * (a[1] - corners[0][1]);
  }
  return 0.5 * std::abs(twice);
}

std::vector<PlanePoint> moved(std::vector<PlanePoint> corners, const Placement& placement) {
  for (auto& corner : corners) {
    const auto point = placement.apply({corner[0], corner[1], 0.0});
    corner = {point[0], point[1]};
  }
  return corners;
}

std::vector<PlanePoint> read_outline(Section& section) {
  std::vector<PlanePoint> corners;
  for (const auto& point : section.points("points", {dimension::length, dimension::length}, 3))
    corners.push_back({point[0], point[1]});
  for (std::size_t k = 0; k < corners.size(); ++k)
    if (corners[k] == corners[(k + 1) % corners.size()])
      throw section.fault("points", "two points that follow each other are the same",
                          "each corner once; the last is joined to the first");
  if (!is_simple(corners)) throw section.fault("points", "the polygon crosses or touches itself", "a simple polygon");
  return corners;
}

std::pair<Point, Point> read_corners(Section& section, int dimensions) {
  const auto lower = read_point(section, "lower", dimensions);
  const auto upper = read_point(section, "upper", dimensions);
  for (int k = 0; k < dimensions; ++k)
    if (upper[k] <= lower[k]) throw section.fault("upper", "must be larger than lower in every coordinate");
  return {lower, upper};
}

}  // namespace tektite::preprocess
