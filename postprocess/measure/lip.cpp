// The lip that a projectile bends out of a plate. Its edge is what of the coherent plate (what hangs on its rim)
// reaches farthest along the flight: it is looked for in every direction around the flight line, sector by sector, so
// that petals and gaps between them count by the angle that they take. Source: G. Young, F. Teixeira-Dias, L. Azevedo,
// J. Mill (2021), Int. J. Mech. Sci. 192, 106108, below table 2: the impact diameter is "twice the average radius of
// the particles at the outermost edges of the plate lip", the lip height "the perpendicular distance between a fixed
// edge particle along the outer face of the plate and a particle on the outermost edges of the lip".

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "postprocess/measure/target.hpp"

namespace tektite {
namespace {

/// Where the exit face is at the rim: the mean place along the flight, in the last state, of the rim's particles that
/// lay in the outermost layer of that face at the start.
double exit_face(const Event& event, const Target& target, const std::vector<bool>& rim) {
  const auto place = places_in(event.initial, event.last);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < event.last.count(); ++i) {
    if (!rim[i]) continue;
    const double depth = target.thickness.high - dot(event.initial.position[place[i]], target.direction);
    if (depth > target.spacing) continue;  // half a spacing of matter lies beyond the outermost layer
    sum += dot(target.seen(event.last.position[i]), target.direction);
    ++count;
  }
  if (count == 0) throw RunError("the rim of the target has no particle on its exit face to measure a lip from");
  return sum / static_cast<double>(count);
}

/// A coherent particle of one sector.
struct Place {
  double along;
  double radius;
};

/// The edge of the lip in one sector.
struct Edge {
  double reach = 0.0;   ///< along the flight
  double radius = 0.0;  ///< from the flight line
  double spread = 0.0;  ///< of the radii of the particles at the edge
};

/// The particles that reach farthest, to within the half spacing that a particle's place is known to. A free edge is no
/// wider than the plate is thick, so what is farther from the innermost of them than that belongs to a bulge and not to
/// the edge. Where the sector does not rise before the exit face there is no lip, and the edge of the hole is the
/// innermost particle.
Edge edge_of(const std::vector<Place>& places, double face, const Target& target) {
  const auto by_reach = [](const Place& a, const Place& b) { return a.along < b.along; };
  const auto by_radius = [](const Place& a, const Place& b) { return a.radius < b.radius; };
  Edge edge;
  edge.reach = std::max_element(places.begin(), places.end(), by_reach)->along;
  if (edge.reach - face < 0.5 * target.spacing) {
    edge.radius = std::min_element(places.begin(), places.end(), by_radius)->radius;
    return edge;
  }
  std::vector<Place> tips;
  for (const auto& place : places)
    if (place.along > edge.reach - 0.5 * target.spacing) tips.push_back(place);
  const double inner = std::min_element(tips.begin(), tips.end(), by_radius)->radius;
  double outer = inner;
  double sum = 0.0;
  std::size_t count = 0;
  for (const auto& tip : tips) {
    if (tip.radius > inner + target.thickness.length()) continue;
    outer = std::max(outer, tip.radius);
    sum += tip.radius;
    ++count;
  }
  edge.radius = sum / static_cast<double>(count);
  edge.spread = outer - inner;
  return edge;
}

struct Lip {
  double face = 0.0;              ///< where the exit face is at the rim, along the flight
  double reach = 0.0;             ///< where the edge is, along the flight: the mean of the sectors
  double radius = 0.0;            ///< of the edge: the mean of the sectors
  double spread = 0.0;            ///< of radii within the edge: the mean of the sectors
  double reach_deviation = 0.0;   ///< standard deviation between the sectors
  double radius_deviation = 0.0;  ///< likewise
  std::size_t sectors = 0;
};

Lip mean_of(const std::vector<Edge>& edges, double face) {
  const double share = 1.0 / static_cast<double>(edges.size());
  Lip lip;
  lip.face = face;
  lip.sectors = edges.size();
  for (const auto& edge : edges) {
    lip.reach += share * edge.reach;
    lip.radius += share * edge.radius;
    lip.spread += share * edge.spread;
  }
  for (const auto& edge : edges) {
    lip.reach_deviation += share * std::pow(edge.reach - lip.reach, 2);
    lip.radius_deviation += share * std::pow(edge.radius - lip.radius, 2);
  }
  lip.reach_deviation = std::sqrt(lip.reach_deviation);
  lip.radius_deviation = std::sqrt(lip.radius_deviation);
  return lip;
}

Lip lip_of(const Event& event, const Fragments& fragments, const Target& target) {
  const auto rim = on_rim(event, target);
  const auto hangs = hangs_on_rim(event, fragments, rim);
  const double face = exit_face(event, target, rim);
  const Sectors sectors(target.direction, event.last.dimensions);
  std::vector<std::vector<Place>> places(sectors.count());
  for (std::size_t i = 0; i < event.last.count(); ++i) {
    if (!hangs[fragments.label[i]]) continue;
    const auto place = target.seen(event.last.position[i]);
    const auto across = target.across(place);
    places[sectors.of(across)].push_back({dot(place, target.direction), norm(across)});
  }
  std::vector<Edge> edges;
  for (const auto& sector : places) {
    if (sector.empty()) throw RunError("the coherent target does not surround the flight line");
    edges.push_back(edge_of(sector, face, target));
  }
  return mean_of(edges, face);
}

/// Throws RunError where the farthest particles stand as near to the flight line as particles of one piece do to each
/// other: then it is the top of a bulge, and there is no hole that could have an edge.
void check_perforated(const Lip& lip, const Target& target) {
  if (lip.radius < link_of_support * target.smoothing_length)
    throw RunError("the target is not perforated: it reaches farthest on the flight line itself, so there is no lip");
}

}  // namespace

/// Keys: body (the target), projectile, axis.
Measure read_impact_diameter(Section& section, const Declared& declared) {
  const auto find_target = read_target(section, declared, true);
  const auto take = [=](const Event& event) {
    const auto target = find_target(event);
    require_across(event, target, Face::back);
    const auto wide = lip_of(event, event.fragments, target);
    const auto narrow = lip_of(event, event.narrow_fragments, target);
    check_perforated(wide, target);
    Measured measured{2.0 * wide.radius, event.last.time, 0.0, {}};
    // Either side of the edge is known to half a spacing, and it lies somewhere in its own width; the sectors' mean has
    // a standard error; the rest is what the choice of the link decides.
    const double error_of_mean = wide.radius_deviation / std::sqrt(static_cast<double>(wide.sectors));
    measured.uncertainty =
        target.spacing + wide.spread + 2.0 * error_of_mean + 2.0 * std::abs(wide.radius - narrow.radius);
    const auto middle = target.unseen(target.on_line(wide.reach));
    const auto side = wide.radius * side_of(target.direction);
    measured.drawing = Segment{middle - side, middle + side};
    return measured;
  };
  return {take, rim_fields};
}

/// Keys: body (the target), projectile, axis.
Measure read_lip_height(Section& section, const Declared& declared) {
  const auto find_target = read_target(section, declared, true);
  const auto take = [=](const Event& event) {
    const auto target = find_target(event);
    require_across(event, target, Face::back);
    const auto wide = lip_of(event, event.fragments, target);
    const auto narrow = lip_of(event, event.narrow_fragments, target);
    check_perforated(wide, target);
    Measured measured{wide.reach - wide.face, event.last.time, 0.0, {}};
    // Face and edge are known to half a spacing each; which place of a ragged edge is taken decides a standard
    // deviation; the rest is what the choice of the link decides.
    measured.uncertainty = target.spacing + wide.reach_deviation + std::abs(wide.reach - narrow.reach);
    const auto side = wide.radius * side_of(target.direction);
    measured.drawing =
        Segment{target.unseen(target.on_line(wide.face)) + side, target.unseen(target.on_line(wide.reach)) + side};
    return measured;
  };
  return {take, rim_fields};
}

}  // namespace tektite
