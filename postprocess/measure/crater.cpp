// The diameter of the crater that a projectile leaves in a target: the widest opening of the cavity between the
// target's original front surface and its deepest point, be it a pit, a hole with curled lips or the bulge of a thin
// plate that is drawn out ahead of the projectile. The cavity is followed along the flight line station by station; at
// each, the innermost coherent matter is looked for in every direction around the line, so that a strand of particles
// across one station does not decide the diameter. What was thrown out in front of the target does not count, and
// neither do loose fragments: the coherent target is what still hangs on the rim, its outermost tenth. The target's
// surface is taken to lie across the flight line (normal impact).

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "postprocess/measure/flight.hpp"

namespace tektite {
namespace {

struct View {
  Point centre;             ///< a point of the flight line
  Point direction;          ///< of flight
  double spacing;           ///< of the target
  double smoothing_length;  ///< of the target, the largest
  Extent thickness;         ///< of the target at the start, along the direction

  Point across(const Point& x) const {
    const auto apart = x - centre;
    return apart - dot(apart, direction) * direction;
  }
};

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
  if (fastest < 0) throw RunError("no body moves against the target, so there is no direction in which a crater opens");
  return fastest;
}

/// Whether each fragment holds a particle that lay in the outermost tenth of the target.
std::vector<bool> hangs_on_rim(const Event& event, const Fragments& fragments, std::int32_t target, const View& view) {
  const auto place = places_in(event.initial, event.last);
  std::vector<double> distance(event.last.count(), 0.0);
  double most = 0.0;
  for (std::size_t i = 0; i < distance.size(); ++i) {
    if (event.last.body[i] != target) continue;
    distance[i] = norm(view.across(event.initial.position[place[i]]));
    most = std::max(most, distance[i]);
  }
  std::vector<bool> hangs(fragments.list.size(), false);
  for (std::size_t i = 0; i < distance.size(); ++i)
    if (event.last.body[i] == target && distance[i] >= 0.9 * most) hangs[fragments.label[i]] = true;
  return hangs;
}

/// A unit vector across the flight, in the plane of a plane scene.
Point side_of(const View& view) {
  const auto& n = view.direction;
  const double length = std::hypot(n[0], n[1]);
  if (length < 0.5) return {1.0, 0.0, 0.0};  // flight along z, up to 30 degrees
  return {-n[1] / length, n[0] / length, 0.0};
}

/// In which direction around the flight line a place lies: two sides in the plane, twelve sectors in space.
class Sectors {
 public:
  Sectors(const View& view, int dimensions)
      : first_(side_of(view)), second_(cross(view.direction, first_)), count_(dimensions == 2 ? 2 : 12) {}

  std::size_t count() const { return count_; }
  std::size_t of(const Point& across) const {
    const double along_first = dot(across, first_);
    if (count_ == 2) return along_first < 0.0 ? 1 : 0;
    const double turn = std::atan2(dot(across, second_), along_first) / (2.0 * std::numbers::pi) + 0.5;
    return std::min(static_cast<std::size_t>(turn * static_cast<double>(count_)), count_ - 1);
  }

 private:
  static Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  Point first_, second_;
  std::size_t count_;
};

struct Crater {
  double diameter = -1.0;
  double depth = 0.0;  ///< along the direction, where it is widest
};

/// What surrounds the flight line in one layer: the distance of the innermost coherent particle in each sector.
struct Station {
  double depth;  ///< of its middle, behind the original front surface
  std::vector<double> inner;

  /// Twice the mean distance, less half a spacing of matter on either side; infinite where a sector is empty.
  double opening(double spacing) const {
    double mean = 0.0;
    for (const double distance : inner) mean += distance / static_cast<double>(inner.size());
    return std::max(0.0, 2.0 * mean - spacing);
  }
};

/// Stations are as thick as two linked particles may be apart and half as far from each other, so that a sheet that
/// hangs together is seen at each; the layer of one spacing at the front surface comes first, for shallow pits.
Crater crater_of(const Event& event, const Fragments& fragments, std::int32_t target, const View& view) {
  const auto hangs = hangs_on_rim(event, fragments, target, view);
  const Sectors sectors(view, dimensions_of(event.last_snapshot.particles.space()));
  const std::vector<double> nothing(sectors.count(), limits::infinite);
  const double step = 0.5 * link_of_support * view.smoothing_length;
  std::vector<Station> stations{{0.5 * view.spacing, nothing}};
  for (std::size_t i = 0; i < event.last.count(); ++i) {
    const double depth = dot(event.last.position[i], view.direction) - view.thickness.low;
    if (!hangs[fragments.label[i]] || depth < 0.0) continue;
    const auto across = view.across(event.last.position[i]);
    const auto add_to = [&](std::size_t station) {
      while (stations.size() <= station) stations.push_back({step * static_cast<double>(stations.size()), nothing});
      auto& distance = stations[station].inner[sectors.of(across)];
      distance = std::min(distance, norm(across));
    };
    if (depth < view.spacing) add_to(0);
    const auto half = static_cast<std::size_t>(depth / step);  // station k reaches from (k - 1) to (k + 1) steps
    if (half > 0) add_to(half);
    add_to(half + 1);
  }
  Crater widest;
  for (const auto& station : stations) {
    const double opening = station.opening(view.spacing);
    if (std::isfinite(opening) && opening > widest.diameter) widest = {opening, view.thickness.low + station.depth};
  }
  if (widest.diameter < 0.0)
    throw RunError("the coherent target does not surround the flight line anywhere behind its original front surface");
  return widest;
}

}  // namespace

/// Keys: body (the target); projectile (default: the body that moves fastest against it); axis.
Measure read_crater_diameter(Section& section, const Declared& declared) {
  if (dimensions_of(declared.space) < 2) throw section.fault("", "a line has no crater", "a plane or solid space");
  const auto body = read_body(section, "body", declared);
  const auto projectile = section.has("projectile") ? read_body(section, "projectile", declared) : std::string();
  const auto axis = read_axis(section, declared.space);
  return [=](const Event& event) {
    const auto target = event.initial.body_named(body);
    const auto flying =
        projectile.empty() ? fastest_other(event.initial, target) : event.initial.body_named(projectile);
    View view;
    view.centre = centre_of_mass(event.initial, flying);
    view.direction = flight_direction(event.initial, flying, axis);
    view.spacing = event.initial.bodies[static_cast<std::size_t>(target)].spacing;
    view.smoothing_length = 0.0;
    for (std::size_t i = 0; i < event.last.count(); ++i)
      if (event.last.body[i] == target)
        view.smoothing_length = std::max(view.smoothing_length, event.last.smoothing_length[i]);
    view.thickness =
        extent_along(event.initial, view.direction, [&](std::size_t i) { return event.initial.body[i] == target; });

    const auto wide = crater_of(event, event.fragments, target, view);
    const auto narrow = crater_of(event, event.narrow_fragments, target, view);
    Measured measured{wide.diameter, event.last.time, 0.0, {}};
    // Either edge is known to half a spacing; the rest is what the choice of the link length decides.
    measured.uncertainty = view.spacing + std::abs(wide.diameter - narrow.diameter);
    const auto on_line = view.centre + (wide.depth - dot(view.centre, view.direction)) * view.direction;
    const auto radius = 0.5 * wide.diameter * side_of(view);
    measured.drawing = Segment{on_line - radius, on_line + radius};
    return measured;
  };
}

}  // namespace tektite
