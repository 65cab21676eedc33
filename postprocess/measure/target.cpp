#include "postprocess/measure/target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace tektite {
namespace {

/// The body that flies fastest relative to the target.
std::int32_t fastest_other(const Whole& initial, std::int32_t target) {
  const auto rest = mean_velocity(initial, target);
  std::int32_t fastest = -1;
  double most = 0.0;
  for (std::int32_t k = 0; k < static_cast<std::int32_t>(initial.bodies.size()); ++k) {
    const double speed = norm(mean_velocity(initial, k) - rest);
    if (k != target && speed > most) {
      most = speed;
      fastest = k;
    }
  }
  if (fastest < 0) throw RunError("no body moves against the target, so there is no direction of impact");
  return fastest;
}

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Clamped particles of the target; none where the run clamps nothing.
std::vector<bool> clamped(const Event& event, const Target& target) {
  std::vector<bool> chosen(event.last.count(), false);
  const auto& particles = event.last_snapshot.particles;
  if (!particles.has(Field::clamped)) return chosen;
  const auto values = particles.integers(Field::clamped);
  for (std::size_t i = 0; i < chosen.size(); ++i)
    chosen[i] = event.last.body[i] == target.body && values[event.last.source[i]] != 0;
  return chosen;
}

/// Where the projectile's centre comes to the plane of the target's foremost matter, which is across an axis that need
/// not be its flight; its centre at the start where it does not come there.
Point met_at(const Event& event, const Target& target) {
  const auto velocity = mean_velocity(event.initial, target.projectile) - mean_velocity(event.initial, target.body);
  const double ahead = target.thickness.low - dot(target.centre, target.direction);
  const double speed = dot(velocity, target.direction);
  return ahead > 0.0 && speed > 0.0 ? target.centre + (ahead / speed) * velocity : target.centre;
}

}  // namespace

FindTarget read_target(Section& section, const Declared& declared, bool needs_across) {
  if (needs_across && dimensions_of(declared.space) < 2)
    throw section.fault("", "a line has nothing across it to measure", "a plane or solid space");
  const auto body = read_body(section, "body", declared);
  const auto projectile = section.has("projectile") ? read_body(section, "projectile", declared) : std::string();
  const auto axis = read_axis(section, declared.space);
  return [=](const Event& event) {
    Target target;
    target.body = event.initial.body_named(body);
    target.projectile =
        projectile.empty() ? fastest_other(event.initial, target.body) : event.initial.body_named(projectile);
    target.centre = centre_of_mass(event.initial, target.projectile);
    target.direction = flight_direction(event.initial, target.projectile, axis);
    target.spacing = event.initial.bodies[static_cast<std::size_t>(target.body)].spacing;
    target.smoothing_length = 0.0;
    for (std::size_t i = 0; i < event.last.count(); ++i)
      if (event.last.body[i] == target.body)
        target.smoothing_length = std::max(target.smoothing_length, event.last.smoothing_length[i]);
    target.thickness = extent_along(event.initial, target.direction,
                                    [&](std::size_t i) { return event.initial.body[i] == target.body; });
    target.carried = (event.last.time - event.initial.time) * mean_velocity(event.initial, target.body);
    if (axis) target.centre = met_at(event, target);
    return target;
  };
}

void require_across(const Event& event, const Target& target, Face face) {
  const auto outward = face == Face::front ? -1.0 * target.direction : target.direction;
  const auto& whole = event.initial;
  double foremost = -limits::infinite;
  for (std::size_t i = 0; i < whole.count(); ++i)
    if (whole.body[i] == target.body) foremost = std::max(foremost, dot(whole.position[i], outward));
  const Sectors sectors(target.direction, whole.dimensions);
  constexpr int turns = 12;  // directions across; in the plane there are two
  std::vector<double> reach(static_cast<std::size_t>(turns), -limits::infinite);
  for (std::size_t i = 0; i < whole.count(); ++i) {
    if (whole.body[i] != target.body || dot(whole.position[i], outward) < foremost - target.spacing) continue;
    const auto across = target.across(whole.position[i]);
    for (int k = 0; k < turns; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / turns;
      const double part = whole.dimensions == 2 ? 0.0 : std::sin(angle);
      const auto side =
          (whole.dimensions == 2 ? (k % 2 ? -1.0 : 1.0) : std::cos(angle)) * sectors.first() + part * sectors.second();
      reach[static_cast<std::size_t>(k)] = std::max(reach[static_cast<std::size_t>(k)], dot(across, side));
    }
  }
  if (*std::min_element(reach.begin(), reach.end()) < -target.spacing)
    throw RunError(
        fmt::format("the target's {} face does not lie across the flight line, which its farthest matter leaves to one "
                    "side; give the measure as axis the direction across that face",
                    face == Face::front ? "front" : "back"));
}

std::vector<bool> on_rim(const Event& event, const Target& target) {
  auto rim = clamped(event, target);
  if (std::find(rim.begin(), rim.end(), true) != rim.end()) return rim;
  const auto place = places_in(event.initial, event.last);
  std::vector<double> distance(event.last.count(), 0.0);
  for (std::size_t i = 0; i < distance.size(); ++i)
    if (event.last.body[i] == target.body) distance[i] = norm(target.across(event.initial.position[place[i]]));
  const double most = *std::max_element(distance.begin(), distance.end());
  for (std::size_t i = 0; i < distance.size(); ++i)
    rim[i] = event.last.body[i] == target.body && distance[i] >= 0.9 * most;
  return rim;
}

std::vector<bool> hangs_on_rim(const Event& event, const Fragments& fragments, const std::vector<bool>& rim) {
  std::vector<bool> hangs(fragments.list.size(), false);
  for (std::size_t i = 0; i < event.last.count(); ++i)
    if (rim[i]) hangs[fragments.label[i]] = true;
  return hangs;
}

Point side_of(const Point& direction) {
  const double length = std::hypot(direction[0], direction[1]);
  if (length < 0.5) {  // flight along z, up to 30 degrees
    const auto side = Point{1.0, 0.0, 0.0} - direction[0] * direction;
    return (1.0 / norm(side)) * side;
  }
  return {-direction[1] / length, direction[0] / length, 0.0};
}

Sectors::Sectors(const Point& direction, int dimensions)
    : first_(side_of(direction)), second_(cross(direction, first_)), count_(dimensions == 2 ? 2 : 12) {}

std::size_t Sectors::of(const Point& across) const {
  const double along_first = dot(across, first_);
  if (count_ == 2) return along_first < 0.0 ? 1 : 0;
  const double turn = std::atan2(dot(across, second_), along_first) / (2.0 * std::numbers::pi) + 0.5;
  return std::min(static_cast<std::size_t>(turn * static_cast<double>(count_)), count_ - 1);
}

}  // namespace tektite
