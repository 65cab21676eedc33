// disc: `centre` and `radius`.

#include "preprocess/geometry/round.hpp"
#include "preprocess/geometry/shapes.hpp"

namespace tektite::preprocess {

ShapePointer read_disc(Section& section, int dimensions) {
  const auto centre = read_point(section, "centre", dimensions, Point{});
  return std::make_unique<RoundShape>(
      2, Round{centre, 0.0, section.quantity("radius", dimension::length, limits::positive)});
}

}  // namespace tektite::preprocess
