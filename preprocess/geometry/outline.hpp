#pragma once
// Polygons in a plane, as profiles of bodies and as bodies themselves.

#include <utility>
#include <vector>

#include "preprocess/geometry/placement.hpp"
#include "preprocess/geometry/region.hpp"

namespace tektite::preprocess {

/// Signed distance to the polygon in m: negative inside. Exact everywhere.
double signed_distance(const std::vector<PlanePoint>& corners, double x, double y);

/// In m², positive in either orientation.
double area(const std::vector<PlanePoint>& corners);

std::vector<PlanePoint> moved(std::vector<PlanePoint> corners, const Placement& placement);

/// Reads `points`, at least three; throws InputError where the polygon is not simple or has no area.
std::vector<PlanePoint> read_outline(Section& section);

/// Reads `lower` and `upper`; throws InputError where upper is not larger in every coordinate.
std::pair<Point, Point> read_corners(Section& section, int dimensions);

}  // namespace tektite::preprocess
