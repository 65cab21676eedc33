#pragma once
// The direction in which a body flies, and how far things reach along it. No measure knows the axes of the scene, so a
// rotated or mirrored scene gives the same values.

#include <optional>
#include <utility>

#include "postprocess/measure/measure.hpp"

namespace tektite {

/// The optional key `axis`: a direction in the coordinates of the space, of any length but zero.
std::optional<Point> read_axis(Section& section, Space space);

/// Unit vector of the body's initial mean velocity relative to that of all other bodies; `axis` where it is given,
/// in the sense in which the body flies along it.
/// Throws RunError where the body does not move and no axis is given.
Point flight_direction(const Whole& initial, std::int32_t body, const std::optional<Point>& axis);

/// Mean velocity of a body, and that of all other bodies; zero where there is none.
Point mean_velocity(const Whole& whole, std::int32_t body);
Point velocity_of_others(const Whole& whole, std::int32_t body);

/// Centre of mass of a body.
Point centre_of_mass(const Whole& whole, std::int32_t body);

struct Extent {
  double low = 0.0;
  double high = 0.0;
  double length() const { return high - low; }
};

/// How far the particles that `chosen(i)` picks reach along a direction, with half a spacing for the matter around the
/// outermost particles. At least one must be picked.
template <class Chosen>
Extent extent_along(const Whole& whole, const Point& direction, const Chosen& chosen) {
  Extent extent{limits::infinite, -limits::infinite};
  for (std::size_t i = 0; i < whole.count(); ++i) {
    if (!chosen(i)) continue;
    const double half = 0.5 * whole.bodies[static_cast<std::size_t>(whole.body[i])].spacing;
    const double along = dot(whole.position[i], direction);
    extent.low = std::min(extent.low, along - half);
    extent.high = std::max(extent.high, along + half);
  }
  return extent;
}

}  // namespace tektite
