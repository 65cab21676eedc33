#include "preprocess/symmetry.hpp"

#include <algorithm>
#include <cmath>

namespace tektite::preprocess {
namespace {

bool on_plane(const Point& position, const SymmetryPlane& plane) { return position[plane.axis] == plane.at; }

/// The part of the box on the kept side; the shape fills it as it filled the box.
Box kept_box(Box box, const SymmetryPlane& plane) {
  if (plane.side > 0.0)
    box.lower[plane.axis] = std::max(box.lower[plane.axis], plane.at);
  else
    box.upper[plane.axis] = std::min(box.upper[plane.axis], plane.at);
  return box;
}

Region rectangle(const Box& box) {
  return Region::polygon({{box.lower[0], box.lower[1]},
                          {box.upper[0], box.lower[1]},
                          {box.upper[0], box.upper[1]},
                          {box.lower[0], box.upper[1]}});
}

bool cuts(const SymmetryPlane& plane, const Box& box) {
  return box.lower[plane.axis] < plane.at && plane.at < box.upper[plane.axis];
}

}  // namespace

void keep_side(std::vector<Point>& positions, std::span<const SymmetryPlane> planes, double tolerance) {
  for (const auto& plane : planes) {
    std::erase_if(positions, [&](const Point& p) { return plane.side * (p[plane.axis] - plane.at) < -tolerance; });
    for (auto& p : positions)
      if (std::abs(p[plane.axis] - plane.at) <= tolerance) p[plane.axis] = plane.at;
  }
}

double mass_share(const Point& position, std::span<const SymmetryPlane> planes) {
  double share = 1.0;
  for (const auto& plane : planes)
    if (on_plane(position, plane)) share *= 0.5;
  return share;
}

Point along_planes(Point velocity, const Point& position, std::span<const SymmetryPlane> planes) {
  for (const auto& plane : planes)
    if (on_plane(position, plane)) velocity[plane.axis] = 0.0;
  return velocity;
}

double kept_measure(const Shape& shape, std::span<const SymmetryPlane> planes) {
  const auto whole = shape.bounds();
  auto kept = whole;
  bool cut = false;
  for (const auto& plane : planes) {
    kept = kept_box(kept, plane);
    cut = cut || cuts(plane, whole);
    if (kept.extent(plane.axis) <= 0.0) return 0.0;
  }
  if (!cut) return shape.measure();
  if (shape.dimensions() == 1) return kept.extent(0);
  if (shape.dimensions() == 2) return shape.region({}).common(rectangle(kept)).area();
  const auto surface = shape.surface({});
  // What the triangles miss of a round face, they miss in the whole too.
  return shape.measure() * surface.volume_within(planes) / surface.volume();
}

}  // namespace tektite::preprocess
