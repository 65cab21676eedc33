// pulse: v_x = speed cos⁴(π (x - centre)/width) within half a width of `centre`, at rest elsewhere. It has three
// continuous derivatives; in an elastic body at rest otherwise it runs off as two halves, one each way (d'Alembert).

#include <cmath>
#include <numbers>

#include "preprocess/velocity/velocity.hpp"

namespace tektite::preprocess {
namespace {

class Pulse final : public VelocityField {
 public:
  Pulse(double speed, double centre, double width) : speed_(speed), centre_(centre), width_(width) {}

  Point at(const Point& x) const override {
    const double share = (x[0] - centre_) / width_;
    if (std::abs(share) >= 0.5) return Point{};
    return {{speed_ * std::pow(std::cos(std::numbers::pi * share), 4), 0.0, 0.0}};
  }

 private:
  double speed_, centre_, width_;
};

}  // namespace

VelocityPointer read_pulse(Section& section, Space) {
  const double speed = section.quantity("speed", dimension::speed, limits::any);
  const double centre = section.quantity("centre", dimension::length, limits::any);
  return std::make_unique<Pulse>(speed, centre, section.quantity("width", dimension::length, limits::positive));
}

}  // namespace tektite::preprocess
