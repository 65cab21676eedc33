#pragma once
// Symmetry planes: half a model stands for the whole. A particle on a plane belongs to both halves, so it stays with
// half its mass; the solver mirrors the other half onto it.

#include <span>
#include <string>
#include <vector>

#include "core/scene.hpp"
#include "preprocess/geometry/shape.hpp"

namespace tektite::preprocess {

/// Removes the particles beyond any plane. Those within `tolerance` (m) of a plane are put exactly on it.
void keep_side(std::vector<Point>& positions, std::span<const SymmetryPlane> planes, double tolerance);

/// Says of each plane that meets the box of a body's shape where the nearest particles of all ranks off it lie neither
/// about half a spacing from it nor behind others that lie on it: they press on their own images, or leave a gap before
/// them.
std::vector<std::string> misaligned(const std::vector<Point>& positions, const Box& box, double spacing,
                                    std::span<const SymmetryPlane> planes);

/// 1 for a particle off all planes; halved for every plane that it lies on.
double mass_share(const Point& position, std::span<const SymmetryPlane> planes);

/// The velocity without what would carry a particle off a plane on which it lies.
Point along_planes(Point velocity, const Point& position, std::span<const SymmetryPlane> planes);

/// Length, area or volume of the part on the kept side of all planes; in the spaces about an axis, of what that sweeps
/// about it. Throws InputError where CGAL cannot cut the shape.
double kept_measure(const Shape& shape, std::span<const SymmetryPlane> planes, Space space);

}  // namespace tektite::preprocess
