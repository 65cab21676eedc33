// radial: everything moves with `speed` towards `centre` (away from it where the speed is negative): Noh's problem.

#include "preprocess/velocity/velocity.hpp"

namespace tektite::preprocess {
namespace {

class Radial final : public VelocityField {
 public:
  Radial(double speed, const Point& centre) : speed_(speed), centre_(centre) {}

  /// v = −v0 e_r; the centre itself is at rest.
  Point at(const Point& x) const override {
    const auto outward = x - centre_;
    const double r = norm(outward);
    return r > 0.0 ? (-speed_ / r) * outward : Point{};
  }

 private:
  double speed_;
  Point centre_;
};

}  // namespace

VelocityPointer read_radial(Section& section, Space space) {
  const double speed = section.quantity("speed", dimension::speed, limits::any);
  return std::make_unique<Radial>(speed, read_point(section, "centre", dimensions_of(space), Point{}));
}

}  // namespace tektite::preprocess
