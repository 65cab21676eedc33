#pragma once
// The initial velocity of a body as a function of place. `velocity = [vx, vy]` is uniform; `velocity = { type = ... }`
// names one of the others, each in the file of its name.

#include <memory>

#include "core/document.hpp"
#include "core/space.hpp"
#include "preprocess/geometry/placement.hpp"

namespace tektite::preprocess {

class VelocityField {
 public:
  virtual ~VelocityField() = default;
  /// In m/s, at x in m.
  virtual Point at(const Point& x) const = 0;
};

using VelocityPointer = std::unique_ptr<VelocityField>;

/// Reads the key `velocity` of a body, at rest where it is left out. Throws InputError; an unknown type is answered
/// with the known ones.
VelocityPointer read_velocity(Section& body, Space space);

VelocityPointer read_uniform(Section& section, Space space);
VelocityPointer read_radial(Section& section, Space space);
VelocityPointer read_radial_inverse(Section& section, Space space);
VelocityPointer read_rotation(Section& section, Space space);
VelocityPointer read_pulse(Section& section, Space space);

}  // namespace tektite::preprocess
