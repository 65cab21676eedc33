// sphere: `centre` and `radius`, and `inner_radius` where it is hollow.

#include "preprocess/geometry/round.hpp"
#include "preprocess/geometry/shapes.hpp"

namespace tektite::preprocess {

ShapePointer read_sphere(Section& section, int dimensions) {
  const auto centre = read_point(section, "centre", dimensions, Point{});
  const double outer = section.quantity("radius", dimension::length, limits::positive);
  const double inner = section.quantity("inner_radius", dimension::length, limits::not_negative, 0.0);
  if (outer <= inner) throw section.fault("inner_radius", "must be smaller than radius");
  return std::make_unique<RoundShape>(3, Round{centre, inner, outer});
}

}  // namespace tektite::preprocess
