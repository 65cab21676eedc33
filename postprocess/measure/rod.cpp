// What is measured of a Taylor bar, in an axisymmetric space or a solid: its length, the rear part that stayed as it
// was, and the face that struck. The bar flies with its face ahead, along the line through its centre of mass. Extents
// are those of the outermost particles. These lie on the surface or up to half a spacing within it, at either end, as
// the arrangement has it, which the snapshots do not tell: the uncertainty of an extent is a whole spacing.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "postprocess/measure/flight.hpp"
#include "postprocess/measure/target.hpp"

namespace tektite {
namespace {

/// Radial strain below which the rod counts as undeformed (Batra and Zhang 2008, section 5).
constexpr double undeformed_strain = 0.002;

constexpr double on_axis = 1e-9;  ///< sine of an angle that is round-off

struct RodPoint {
  double start[2];  ///< radius and height over the centre in the initial state, m
  double now[2];
};

struct Rod {
  std::vector<RodPoint> points;
  Point centre;  ///< of mass at the start: heights count from there
  Point up;      ///< unit vector from the face to the tail
  double spacing = 0.0;
  double time = 0.0;

  Point at(double height, const Point& across = Point::zero()) const { return centre + height * up + across; }

  double extreme(bool start, int k, double sign) const {
    double best = -std::numeric_limits<double>::infinity();
    for (const auto& p : points) best = std::max(best, sign * (start ? p.start[k] : p.now[k]));
    return sign * best;
  }
};

Rod rod_of(const Event& event, const std::string& name, const std::optional<Point>& axis) {
  const auto space = event.last_snapshot.particles.space();
  if (space != Space::solid && space != Space::axisymmetric)
    throw RunError(fmt::format("a rod is measured in an axisymmetric space or a solid, not in {}", name_of(space)));
  const auto& initial = event.initial;
  const auto body = initial.body_named(name);
  Rod rod;
  rod.centre = centre_of_mass(initial, body);
  rod.up = -1.0 * flight_direction(initial, body, axis);
  if (space == Space::axisymmetric) {
    rod.centre[0] = 0.0;
    if (std::abs(rod.up[0]) > on_axis) throw RunError("in an axisymmetric space a rod flies along y");
  }
  const auto point = [&](const Point& x) {
    const auto apart = x - rod.centre;
    const double height = dot(apart, rod.up);
    return std::pair{norm(apart - height * rod.up), height};
  };
  const auto place = places_in(initial, event.last);
  const auto& range = event.last.bodies[static_cast<std::size_t>(body)];
  rod.spacing = range.spacing;
  rod.time = event.last.time;
  for (auto i = range.range.begin; i < range.range.end; ++i) {
    const auto [start_radius, start_height] = point(initial.position[place[i]]);
    const auto [radius, height] = point(event.last.position[i]);
    rod.points.push_back({{start_radius, start_height}, {radius, height}});
  }
  return rod;
}

/// The mantle from the tail, which is above, to the face.
std::vector<RodPoint> mantle_of(const Rod& rod) {
  const double radius = rod.extreme(true, 0, 1.0);
  std::vector<RodPoint> mantle;
  for (const auto& p : rod.points)
    if (p.start[0] > radius - 0.5 * rod.spacing) mantle.push_back(p);
  std::ranges::sort(mantle, [](const auto& a, const auto& b) { return a.start[1] > b.start[1]; });
  return mantle;
}

double radial_strain(const RodPoint& p) { return std::abs(p.now[0] - p.start[0]) / p.start[0]; }

Measured final_length(const Rod& rod) {
  const double top = rod.extreme(false, 1, 1.0), bottom = rod.extreme(false, 1, -1.0);
  const Segment drawn{rod.at(bottom), rod.at(top)};
  return {top - bottom, rod.time, rod.spacing, drawn};
}

/// Along the mantle, to where the strain passes the limit; linear between two particles.
Measured undeformed_length(const Rod& rod) {
  const auto mantle = mantle_of(rod);
  std::size_t k = 0;
  while (k < mantle.size() && radial_strain(mantle[k]) < undeformed_strain) ++k;
  if (k == 0) throw RunError("the tail itself is deformed");
  double end = mantle[k - 1].now[1];
  if (k < mantle.size()) {
    const double before = radial_strain(mantle[k - 1]), after = radial_strain(mantle[k]);
    end += (mantle[k].now[1] - end) * (undeformed_strain - before) / (after - before);
  }
  return {mantle.front().now[1] - end, rod.time, rod.spacing, {}};
}

Measured face_diameter(const Rod& rod) {
  const double face = rod.extreme(true, 1, -1.0);
  double radius = 0.0, height = 0.0;
  for (const auto& p : rod.points)
    if (p.start[1] < face + 0.5 * rod.spacing && p.now[0] > radius) {
      radius = p.now[0];
      height = p.now[1];
    }
  const auto side = radius * side_of(rod.up);
  return {2.0 * radius, rod.time, rod.spacing, Segment{rod.at(height, -1.0 * side), rod.at(height, side)}};
}

template <Measured (*measure)(const Rod&)>
Measure read_rod(Section& section, const Declared& declared) {
  const auto body = read_body(section, "body", declared);
  const auto axis = read_axis(section, declared.space);
  return [=](const Event& event) { return measure(rod_of(event, body, axis)); };
}

}  // namespace

Measure read_final_length(Section& section, const Declared& declared) {
  return read_rod<final_length>(section, declared);
}

Measure read_undeformed_length(Section& section, const Declared& declared) {
  return read_rod<undeformed_length>(section, declared);
}

Measure read_face_diameter(Section& section, const Declared& declared) {
  return read_rod<face_diameter>(section, declared);
}

}  // namespace tektite
