// ring: what lies between two radii about `centre`, in the plane.

#include "preprocess/geometry/round.hpp"
#include "preprocess/geometry/shapes.hpp"

namespace tektite::preprocess {

ShapePointer read_ring(Section& section, int dimensions) {
  const auto centre = read_point(section, "centre", dimensions, Point{});
  const double inner = section.quantity("inner_radius", dimension::length, limits::positive);
  const double outer = section.quantity("outer_radius", dimension::length, limits::positive);
  if (outer <= inner) throw section.fault("outer_radius", "must be larger than inner_radius");
  return std::make_unique<RoundShape>(2, Round{centre, inner, outer});
}

}  // namespace tektite::preprocess
