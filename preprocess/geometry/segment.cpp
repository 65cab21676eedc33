// segment: from `lower` to `upper` on a line.

#include <algorithm>
#include <cmath>

#include "preprocess/geometry/shapes.hpp"

namespace tektite::preprocess {
namespace {

class Segment final : public Shape {
 public:
  Segment(double lower, double upper) : lower_(lower), upper_(upper) {}

  int dimensions() const override { return 1; }
  bool inside(const Point& x, double tolerance) const override {
    return std::max(lower_ - x[0], x[0] - upper_) <= tolerance;
  }
  double reach(const Point& n) const override { return std::max(n[0] * lower_, n[0] * upper_); }
  double measure() const override { return upper_ - lower_; }

 private:
  double lower_, upper_;
};

}  // namespace

ShapePointer read_segment(Section& section, int) {
  const double lower = section.quantity("lower", dimension::length, limits::any);
  const double upper = section.quantity("upper", dimension::length, limits::any);
  if (upper <= lower) throw section.fault("upper", "must be larger than lower");
  return std::make_unique<Segment>(lower, upper);
}

}  // namespace tektite::preprocess
