// The diameter of the crater or hole that a projectile leaves in a target.
//
// Looked at along the flight line, the coherent target leaves an opening around that line. Where the target is
// perforated, the opening is taken over the whole original thickness: the clear width through which one can see, the
// narrowest place between the coherent parts. Where it is not, it is taken at the original front surface. Material that
// has left the original thickness (lips, bulges) does not count, and neither do loose fragments: the coherent target is
// what still hangs on the rim, its outermost tenth. In the plane the opening is the sum of its radii on both
// sides of the flight line; in space it is the diameter of the circle of equal area, found from the nearest particle in
// each sector around the line. The surface of the target is taken to lie across the flight line (normal impact).

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "postprocess/measure/flight.hpp"

namespace tektite {
namespace {

struct View {
  Point centre;      ///< a point of the flight line
  Point direction;   ///< of flight
  double spacing;    ///< of the target
  Extent thickness;  ///< of the target at the start, along the direction

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

/// Positions across the flight line of the coherent target's particles within a layer.
std::vector<Point> layer(const Event& event, const Fragments& fragments, const std::vector<bool>& hangs,
                         const View& view, const Extent& depth) {
  std::vector<Point> found;
  for (std::size_t i = 0; i < event.last.count(); ++i) {
    const double along = dot(event.last.position[i], view.direction);
    if (hangs[fragments.label[i]] && along >= depth.low && along <= depth.high)
      found.push_back(view.across(event.last.position[i]));
  }
  return found;
}

struct Opening {
  double diameter = 0.0;
  Point low = Point::zero();  ///< its edges across the flight line, relative to the line
  Point high = Point::zero();
};

/// In the plane: the nearest particles on both sides of the flight line.
Opening plane_opening(const std::vector<Point>& points, const View& view) {
  const Point side{-view.direction[1], view.direction[0], 0.0};
  double low = -limits::infinite;
  double high = limits::infinite;
  for (const auto& point : points) {
    const double u = dot(point, side);
    if (u <= 0.0) low = std::max(low, u);
    if (u >= 0.0) high = std::min(high, u);
  }
  if (!std::isfinite(high - low)) throw RunError("the coherent target does not reach to both sides of the flight line");
  low = std::min(0.0, low + 0.5 * view.spacing);
  high = std::max(0.0, high - 0.5 * view.spacing);
  return {high - low, low * side, high * side};
}

/// In space: the area between the nearest particles of all sectors. A sector is one and a half spacings wide at the
/// nearest particle of all, so that each holds one even if the hole is not round.
Opening space_opening(const std::vector<Point>& points, const View& view) {
  double nearest = limits::infinite;
  for (const auto& point : points) nearest = std::min(nearest, norm(point));
  if (!std::isfinite(nearest)) throw RunError("the coherent target has left its original thickness");
  const int smallest = std::abs(view.direction[0]) < 0.6 ? 0 : 1;
  auto first = Point::zero();
  first[smallest] = 1.0;
  first = first - dot(first, view.direction) * view.direction;
  first = (1.0 / norm(first)) * first;
  const Point& n = view.direction;
  const Point second{n[1] * first[2] - n[2] * first[1], n[2] * first[0] - n[0] * first[2],
                     n[0] * first[1] - n[1] * first[0]};

  const auto sectors =
      static_cast<std::size_t>(std::max(8.0, std::floor(2.0 * std::numbers::pi * nearest / (1.5 * view.spacing))));
  std::vector<double> radius(sectors, limits::infinite);
  for (const auto& point : points) {
    const double turn = std::atan2(dot(point, second), dot(point, first)) / (2.0 * std::numbers::pi) + 0.5;
    const auto sector = std::min(sectors - 1, static_cast<std::size_t>(turn * static_cast<double>(sectors)));
    radius[sector] = std::min(radius[sector], norm(point));
  }
  double squares = 0.0;
  for (const double r : radius) {
    if (!std::isfinite(r)) throw RunError("the coherent target does not surround the flight line");
    const double clear = std::max(0.0, r - 0.5 * view.spacing);
    squares += clear * clear;
  }
  const double mean = std::sqrt(squares / static_cast<double>(sectors));
  return {2.0 * mean, -mean * first, mean * first};
}

struct Crater {
  Opening opening;
  double depth;  ///< along the direction, where it is drawn
};

Crater crater_of(const Event& event, const Fragments& fragments, std::int32_t target, const View& view) {
  const auto hangs = hangs_on_rim(event, fragments, target, view);
  const auto opening_in = [&](const Extent& depth) {
    const auto points = layer(event, fragments, hangs, view, depth);
    return event.last.dimensions == 2 ? plane_opening(points, view) : space_opening(points, view);
  };
  const auto& thickness = view.thickness;
  const auto through = opening_in(thickness);
  // An opening below two spacings is the play between particles, not a hole.
  if (through.diameter > 2.0 * view.spacing) return {through, 0.5 * (thickness.low + thickness.high)};
  const auto front = opening_in({thickness.low, thickness.low + view.spacing});
  return {front, thickness.low};
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
    view.thickness =
        extent_along(event.initial, view.direction, [&](std::size_t i) { return event.initial.body[i] == target; });

    const auto wide = crater_of(event, event.fragments, target, view);
    const auto narrow = crater_of(event, event.narrow_fragments, target, view);
    Measured measured{wide.opening.diameter, event.last.time, 0.0, {}};
    // Either edge is known to half a spacing; the rest is what the choice of the link length decides.
    measured.uncertainty = view.spacing + std::abs(wide.opening.diameter - narrow.opening.diameter);
    const auto on_line = view.centre + (wide.depth - dot(view.centre, view.direction)) * view.direction;
    measured.drawing = Segment{on_line + wide.opening.low, on_line + wide.opening.high};
    return measured;
  };
}

}  // namespace tektite
