// radial-inverse: towards `centre` with `speed` at distance `radius` and inversely proportional to the distance
// elsewhere: the volume-keeping motion of a collapsing ring (godunov.txt eq. 38).

#include "preprocess/velocity/velocity.hpp"

namespace tektite::preprocess {
namespace {

class RadialInverse final : public VelocityField {
 public:
  RadialInverse(double speed, double radius, const Point& centre) : strength_(speed * radius), centre_(centre) {}

  /// v = −v0 (R1/r) e_r; the centre itself, where that has no limit, is at rest.
  Point at(const Point& x) const override {
    const auto outward = x - centre_;
    const double r_squared = dot(outward, outward);
    return r_squared > 0.0 ? (-strength_ / r_squared) * outward : Point{};
  }

 private:
  double strength_;
  Point centre_;
};

}  // namespace

VelocityPointer read_radial_inverse(Section& section, Space space) {
  const double speed = section.quantity("speed", dimension::speed, limits::any);
  const double radius = section.quantity("radius", dimension::length, limits::positive);
  return std::make_unique<RadialInverse>(speed, radius, read_point(section, "centre", dimensions_of(space), Point{}));
}

}  // namespace tektite::preprocess
