// rotation: rigid spin at `rate` about the point `centre`; about `axis` in solids, about z in the plane; no
// section about an axis has one.

#include "preprocess/velocity/velocity.hpp"

namespace tektite::preprocess {
namespace {

class Rotation final : public VelocityField {
 public:
  Rotation(const Point& rate, const Point& centre) : rate_(rate), centre_(centre) {}

  /// v = ω × (x − c)
  Point at(const Point& x) const override {
    const auto r = x - centre_;
    return {rate_[1] * r[2] - rate_[2] * r[1], rate_[2] * r[0] - rate_[0] * r[2], rate_[0] * r[1] - rate_[1] * r[0]};
  }

 private:
  Point rate_, centre_;
};

}  // namespace

VelocityPointer read_rotation(Section& section, Space space) {
  const std::string others = "uniform, radial, radial-inverse";
  if (dimensions_of(space) == 1) throw section.fault("type", "nothing rotates on a line", others);
  if (space == Space::axisymmetric)
    throw section.fault("type", "a section about an axis does not turn in its own plane, and has no spin", others);
  const Point z{{0.0, 0.0, 1.0}};
  const double rate = section.quantity("rate", dimension::rate, limits::any);
  const auto axis = space == Space::solid ? read_direction(section, "axis", z) : z;
  return std::make_unique<Rotation>(rate * axis, read_point(section, "centre", dimensions_of(space), Point{}));
}

}  // namespace tektite::preprocess
