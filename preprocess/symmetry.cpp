#include "preprocess/symmetry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "parallel/ranks.hpp"
#include "preprocess/arrangement/arrangement.hpp"

namespace tektite::preprocess {
namespace {

/// Of the nearest particles off a plane, in spacings: half of one fits their images, and a fifth of it more or less is
/// what hexagonal and stretched lattices need.
constexpr double least_distance = 0.4;
constexpr double most_distance = 0.6;

bool on_plane(const Point& position, const SymmetryPlane& plane) { return position[plane.axis] == plane.at; }

/// The part of the box on the kept side; the shape fills it as it filled the box.
Box kept_box(Box box, const SymmetryPlane& plane) {
  if (plane.side > 0.0)
    box.lower[plane.axis] = std::max(box.lower[plane.axis], plane.at);
  else
    box.upper[plane.axis] = std::min(box.upper[plane.axis], plane.at);
  return box;
}

/// Of particles, on all ranks: whether any lies on a plane, and how far (m) from it the nearest of the others is.
struct AboutPlane {
  bool some_on_plane = false;
  double nearest = std::numeric_limits<double>::infinity();
};

AboutPlane about_plane(const std::vector<Point>& positions, const SymmetryPlane& plane) {
  AboutPlane about;
  for (const auto& p : positions)
    if (on_plane(p, plane))
      about.some_on_plane = true;
    else
      about.nearest = std::min(about.nearest, std::abs(p[plane.axis] - plane.at));
  return of_all_ranks(about, [](AboutPlane& whole, const AboutPlane& part) {
    whole.some_on_plane = whole.some_on_plane || part.some_on_plane;
    whole.nearest = std::min(whole.nearest, part.nearest);
  });
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

/// Area or volume that the part of the shape within the box sweeps about the axis, or as a shell about the centre.
double swept_measure(const Shape& shape, const Box& kept, Space space) {
  constexpr double pi = std::numbers::pi;
  const double inner = kept.lower[0], outer = kept.upper[0];
  if (space == Space::cylindrical) return pi * (outer * outer - inner * inner);
  if (space == Space::spherical) return 4.0 / 3.0 * pi * (std::pow(outer, 3) - std::pow(inner, 3));
  return 2.0 * pi * shape.region({}).common(rectangle(kept)).first_moment();
}

}  // namespace

void keep_side(std::vector<Point>& positions, std::span<const SymmetryPlane> planes, double tolerance) {
  for (const auto& plane : planes) {
    std::erase_if(positions, [&](const Point& p) { return plane.side * (p[plane.axis] - plane.at) < -tolerance; });
    for (auto& p : positions)
      if (std::abs(p[plane.axis] - plane.at) <= tolerance) p[plane.axis] = plane.at;
  }
}

std::vector<std::string> misaligned(const std::vector<Point>& positions, const Box& box, double spacing,
                                    std::span<const SymmetryPlane> planes) {
  std::vector<std::string> warnings;
  for (const auto& plane : planes) {
    const double tolerance = edge_tolerance * spacing;
    if (plane.at < box.lower[plane.axis] - tolerance || plane.at > box.upper[plane.axis] + tolerance) continue;
    const auto [some_on_plane, nearest] = about_plane(positions, plane);
    const bool too_near = nearest < least_distance * spacing;
    const bool too_far = !some_on_plane && nearest > most_distance * spacing;
    if (too_near || too_far)
      warnings.push_back(fmt::format(
          "the particles nearest to the symmetry plane {} = {:g} m lie {:g} m from it, {:.2g} spacings, which {}; half "
          "a "
          "spacing, or particles on the plane, would fit their images. What helps: a spacing that divides the distance "
          "from the shape's edge to the plane, or the arrangement lattice with the convention half-off-origin or "
          "on-origin and its origin on the plane",
          "xyz"[plane.axis], plane.at, nearest, nearest / spacing,
          too_near ? "is too near to their own images" : "leaves a gap before their images"));
  }
  return warnings;
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

double kept_measure(const Shape& shape, std::span<const SymmetryPlane> planes, Space space) {
  const auto whole = shape.bounds();
  auto kept = whole;
  bool cut = false;
  for (const auto& plane : planes) {
    kept = kept_box(kept, plane);
    cut = cut || cuts(plane, whole);
    if (kept.extent(plane.axis) <= 0.0) return 0.0;
  }
  if (hoops_of(space) > 0) return swept_measure(shape, kept, space);
  if (!cut) return shape.measure();
  if (shape.dimensions() == 1) return kept.extent(0);
  if (shape.dimensions() == 2) return shape.region({}).common(rectangle(kept)).area();
  const auto surface = shape.surface({});
  // What the triangles miss of a round face, they miss in the whole too.
  return shape.measure() * surface.volume_within(planes) / surface.volume();
}

}  // namespace tektite::preprocess
