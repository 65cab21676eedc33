#pragma once
// Points, boxes and rigid motions of the preprocessor. A point always has three coordinates; those that the space does
// not have are zero, so that one shape, one row and one arrangement serve every space.

#include <array>

#include "core/document.hpp"
#include "core/tensor.hpp"

namespace tektite::preprocess {

using Point = Vector<double, 3>;

struct Box {
  Point lower{};
  Point upper{};
  double extent(int axis) const { return upper[axis] - lower[axis]; }
};

/// A rotation followed by a translation: x' = R x + t.
class Placement {
 public:
  Placement() = default;  ///< leaves everything where it is
  /// Turns by `angle` (radians, right-handed) about the unit vector `axis` through the point `about`.
  static Placement rotation(double angle, const Point& axis, const Point& about);
  static Placement translation(const Point& by);

  Point apply(const Point& x) const;
  Point apply_inverse(const Point& x) const;
  Point turn(const Point& direction) const;
  Point turn_inverse(const Point& direction) const;
  /// The motion that first does `first`, then this one.
  Placement after(const Placement& first) const;
  bool is_identity() const;

 private:
  std::array<Point, 3> rows_{{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};
  Point shift_{};
};

/// Reads the optional keys `rotate = { angle, axis, about }` and `translate` of a shape in `dimensions` coordinates;
/// the rotation comes first. `axis` belongs to solids alone: in the plane the axis is z. Throws InputError.
Placement read_placement(Section& section, int dimensions);

/// A list of `dimensions` lengths in m, as a point.
Point read_point(Section& section, const std::string& key, int dimensions);
Point read_point(Section& section, const std::string& key, int dimensions, const Point& otherwise);

/// A direction as a list of three numbers, not all zero; returned with length 1.
Point read_direction(Section& section, const std::string& key, const Point& otherwise);

}  // namespace tektite::preprocess
