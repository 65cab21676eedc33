#pragma once
// Solids of revolution, seen in their own frame: `axial` along the axis from the base point, `radial` across it.

#include <cmath>

#include "preprocess/geometry/shape.hpp"

namespace tektite::preprocess {

struct Axis {
  Point base{};
  Point direction{{1.0, 0.0, 0.0}};  ///< of length 1
};

class AxialShape : public Shape {
 public:
  explicit AxialShape(const Axis& axis) : axis_(axis) {}

  int dimensions() const override { return 3; }
  bool inside(const Point& x, double tolerance) const override;
  double reach(const Point& direction) const override;
  Surface surface(const Placement& placement) const override;

 protected:
  /// The profile's own questions: is (axial, radial >= 0) inside; the largest axial a + radial r over the profile with
  /// r >= 0; and the closed outline that stands for it in a triangulation, from axis to axis.
  virtual bool profile_inside(double axial, double radial, double tolerance) const = 0;
  virtual double profile_reach(double a, double r) const = 0;
  virtual std::vector<PlanePoint> outline() const = 0;

 private:
  Axis axis_;
};

/// Reads `axis`, a direction, x where it is left out, and the point under `base_key`, the origin where it is left out.
Axis read_axis(Section& section, const std::string& base_key);

}  // namespace tektite::preprocess
