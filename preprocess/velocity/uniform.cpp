// uniform: the same `velocity` everywhere.

#include "preprocess/velocity/velocity.hpp"

namespace tektite::preprocess {
namespace {

class Uniform final : public VelocityField {
 public:
  explicit Uniform(const Point& velocity) : velocity_(velocity) {}
  Point at(const Point&) const override { return velocity_; }

 private:
  Point velocity_;
};

}  // namespace

VelocityPointer read_uniform(Section& section, Space space) {
  const int dimensions = dimensions_of(space);
  Point velocity{};
  if (section.has("velocity")) {
    const auto values = section.quantities("velocity", dimension::speed, static_cast<std::size_t>(dimensions));
    for (int k = 0; k < dimensions; ++k) velocity[k] = values[static_cast<std::size_t>(k)];
  }
  return std::make_unique<Uniform>(velocity);
}

}  // namespace tektite::preprocess
