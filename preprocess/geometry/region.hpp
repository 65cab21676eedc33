#pragma once
// Regions of the plane that segments and circular arcs bound, with exact union, difference and intersection: CGAL's
// Boolean_set_operations_2 over circle segments in exact arithmetic. Only the final area is rounded.

#include <array>
#include <memory>
#include <vector>

namespace tektite::preprocess {

using PlanePoint = std::array<double, 2>;

class Region {
 public:
  /// The inside of a simple polygon, in either orientation.
  static Region polygon(const std::vector<PlanePoint>& corners);
  static Region disc(const PlanePoint& centre, double radius);

  Region joined(const Region& other) const;
  Region without(const Region& other) const;
  Region common(const Region& other) const;

  /// In m².
  double area() const;
  /// ∫ x dA in m³: what the region sweeps about the axis x = 0, over 2π.
  double first_moment() const;

 private:
  struct Set;
  explicit Region(std::shared_ptr<const Set> set) : set_(std::move(set)) {}
  std::shared_ptr<const Set> set_;
};

/// Whether the edges of a polygon neither cross nor touch but at common corners.
bool is_simple(const std::vector<PlanePoint>& corners);

}  // namespace tektite::preprocess
