#include "postprocess/measure/flight.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace tektite {
namespace {

struct Moments {
  double mass = 0.0;
  Point first = Point::zero();  ///< Σ m a

  void add(double m, const Point& a) {
    mass += m;
    first += m * a;
  }
  Point mean() const { return mass > 0.0 ? (1.0 / mass) * first : Point::zero(); }
};

template <class Chosen>
Point mean_of(const std::vector<Point>& vectors, const Whole& whole, const Chosen& chosen) {
  Moments moments;
  for (std::size_t i = 0; i < whole.count(); ++i)
    if (chosen(i)) moments.add(whole.mass[i], vectors[i]);
  return moments.mean();
}

}  // namespace

std::optional<Point> read_axis(Section& section, Space space) {
  if (!section.has("axis")) return std::nullopt;
  const auto count = static_cast<std::size_t>(dimensions_of(space));
  const auto values = section.quantities("axis", dimension::none, count);
  auto axis = Point::zero();
  for (std::size_t k = 0; k < count; ++k) axis[static_cast<int>(k)] = values[k];
  if (norm(axis) == 0.0) throw section.fault("axis", "a direction cannot be zero");
  return (1.0 / norm(axis)) * axis;
}

Point mean_velocity(const Whole& whole, std::int32_t body) {
  return mean_of(whole.velocity, whole, [&](std::size_t i) { return whole.body[i] == body; });
}

Point velocity_of_others(const Whole& whole, std::int32_t body) {
  return mean_of(whole.velocity, whole, [&](std::size_t i) { return whole.body[i] != body; });
}

Point centre_of_mass(const Whole& whole, std::int32_t body) {
  return mean_of(whole.position, whole, [&](std::size_t i) { return whole.body[i] == body; });
}

Point flight_direction(const Whole& initial, std::int32_t body, const std::optional<Point>& axis) {
  const auto velocity = mean_velocity(initial, body) - velocity_of_others(initial, body);
  if (axis) return dot(*axis, velocity) < 0.0 ? -1.0 * *axis : *axis;
  const double speed = norm(velocity);
  if (speed == 0.0)
    throw RunError(
        fmt::format("{} does not move at the start, so it has no direction of flight; give the measure an axis",
                    initial.bodies[static_cast<std::size_t>(body)].name));
  return (1.0 / speed) * velocity;
}

}  // namespace tektite
