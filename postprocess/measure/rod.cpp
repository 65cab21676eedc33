// What is measured of a Taylor bar, in an axisymmetric space or a solid, along y about the origin: its length, the rear
// part that stayed as it was, and the face that struck. Extents are those of the outermost particles. These lie on the
// surface or up to half a spacing within it, at either end, as the arrangement has it, which the snapshots do not tell:
// the uncertainty of an extent is a whole spacing.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "postprocess/measure/measure.hpp"

namespace tektite {
namespace {

/// Radial strain below which the rod counts as undeformed (Batra and Zhang 2008, section 5).
constexpr double undeformed_strain = 0.002;

struct RodPoint {
  double start[2];  ///< radius and height in the initial state, m
  double now[2];
};

struct Rod {
  std::vector<RodPoint> points;
  double spacing = 0.0;
  double time = 0.0;

  double extreme(bool start, int k, double sign) const {
    double best = -std::numeric_limits<double>::infinity();
    for (const auto& p : points) best = std::max(best, sign * (start ? p.start[k] : p.now[k]));
    return sign * best;
  }
};

Rod rod_of(const Event& event, const std::string& name) {
  const auto& particles = event.last_snapshot.particles;
  const bool solid = particles.space() == Space::solid;
  if (!solid && particles.space() != Space::axisymmetric)
    throw RunError(
        fmt::format("a rod is measured in an axisymmetric space or a solid, not in {}", name_of(particles.space())));
  const auto radius = [solid](const auto& x) { return solid ? std::hypot(x[0], x[2]) : x[0]; };
  const auto place = places_in(event.initial, event.last);
  const auto& body = event.last.bodies[static_cast<std::size_t>(event.last.body_named(name))];
  Rod rod;
  rod.spacing = body.spacing;
  rod.time = event.last.time;
  for (auto i = body.range.begin; i < body.range.end; ++i) {
    const auto& start = event.initial.position[place[i]];
    const auto& now = event.last.position[i];
    rod.points.push_back({{radius(start), start[1]}, {radius(now), now[1]}});
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

Measured final_length(const Event& event, const std::string& name) {
  const auto rod = rod_of(event, name);
  const double top = rod.extreme(false, 1, 1.0), bottom = rod.extreme(false, 1, -1.0);
  const Segment drawn{{0.0, bottom, 0.0}, {0.0, top, 0.0}};
  return {top - bottom, rod.time, rod.spacing, drawn};
}

/// Along the mantle, to where the strain passes the limit; linear between two particles.
Measured undeformed_length(const Event& event, const std::string& name) {
  const auto rod = rod_of(event, name);
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

Measured face_diameter(const Event& event, const std::string& name) {
  const auto rod = rod_of(event, name);
  const double face = rod.extreme(true, 1, -1.0);
  double radius = 0.0, height = 0.0;
  for (const auto& p : rod.points)
    if (p.start[1] < face + 0.5 * rod.spacing && p.now[0] > radius) {
      radius = p.now[0];
      height = p.now[1];
    }
  return {2.0 * radius, rod.time, rod.spacing, Segment{{-radius, height, 0.0}, {radius, height, 0.0}}};
}

template <Measured (*measure)(const Event&, const std::string&)>
Measure read_rod(Section& section, const Declared& declared) {
  const auto body = read_body(section, "body", declared);
  return [=](const Event& event) { return measure(event, body); };
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
