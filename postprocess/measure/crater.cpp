// The diameter of the crater that a projectile leaves in a target: the widest opening of the cavity between the
// target's original front surface and its deepest point, be it a pit, a hole with curled lips or the bulge of a thin
// plate that is drawn out ahead of the projectile. The cavity is followed along the flight line station by station; at
// each, the innermost coherent matter is looked for in every direction around the line, so that a strand of particles
// across one station does not decide the diameter. What was thrown out in front of the target does not count, and
// neither do loose fragments: the coherent target is what still hangs on its rim. The target's
// surface is taken to lie across the flight line (normal impact). Its depth is that of the coherent target's first
// matter on the flight line: what is left of the projectile on the floor counts as part of the cavity, as in a section
// that is measured to the target's metal.

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "postprocess/measure/target.hpp"

namespace tektite {
namespace {

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
/// hangs together is seen at each. The one at the front surface, which comes first, is for shallow pits: it ends one
/// spacing behind the surface, and reaches as far before it as a sheet that is bent back and stretched there needs.
Crater crater_of(const Event& event, const Fragments& fragments, const Target& target) {
  const auto hangs = hangs_on_rim(event, fragments, on_rim(event, target));
  const Sectors sectors(target.direction, event.last.dimensions);
  const std::vector<double> nothing(sectors.count(), limits::infinite);
  const double step = 0.5 * link_of_support * target.smoothing_length;
  std::vector<Station> stations{{0.5 * target.spacing, nothing}};
  for (std::size_t i = 0; i < event.last.count(); ++i) {
    const auto place = target.seen(event.last.position[i]);
    const double depth = dot(place, target.direction) - target.thickness.low;
    if (!hangs[fragments.label[i]] || depth < target.spacing - 2.0 * step) continue;
    const auto across = target.across(place);
    const auto add_to = [&](std::size_t station) {
      while (stations.size() <= station) stations.push_back({step * static_cast<double>(stations.size()), nothing});
      auto& distance = stations[station].inner[sectors.of(across)];
      distance = std::min(distance, norm(across));
    };
    if (depth < target.spacing) add_to(0);
    if (depth < 0.0) continue;
    const auto half = static_cast<std::size_t>(depth / step);  // station k reaches from (k - 1) to (k + 1) steps
    if (half > 0) add_to(half);
    add_to(half + 1);
  }
  Crater widest;
  for (const auto& station : stations) {
    const double opening = station.opening(target.spacing);
    if (std::isfinite(opening) && opening > widest.diameter) widest = {opening, target.thickness.low + station.depth};
  }
  if (widest.diameter < 0.0)
    throw RunError("the coherent target does not surround the flight line anywhere behind its original front surface");
  return widest;
}

/// Where the coherent target begins within `reach` of the flight line, along the direction; nothing where it has none
/// there.
std::optional<double> floor_within(double reach, const Event& event, const Target& target,
                                   const std::vector<bool>& hangs) {
  std::optional<double> first;
  for (std::size_t i = 0; i < event.last.count(); ++i) {
    const auto place = target.seen(event.last.position[i]);
    if (!hangs[event.fragments.label[i]] || norm(target.across(place)) > reach) continue;
    const double along = dot(place, target.direction);
    if (!first || along < *first) first = along;
  }
  return first;
}

/// Whether the target had matter within `reach` of the flight line at the start.
bool lay_within(double reach, const Event& event, const Target& target) {
  for (std::size_t i = 0; i < event.initial.count(); ++i)
    if (event.initial.body[i] == target.body && norm(target.across(event.initial.position[i])) <= reach) return true;
  return false;
}

}  // namespace

/// Keys: body (the target); projectile (default: the body that moves fastest against it); axis.
Measure read_crater_diameter(Section& section, const Declared& declared) {
  const auto find_target = read_target(section, declared, true);
  const auto take = [=](const Event& event) {
    const auto target = find_target(event);
    require_across(event, target, Face::front);
    const auto wide = crater_of(event, event.fragments, target);
    const auto narrow = crater_of(event, event.narrow_fragments, target);
    Measured measured{wide.diameter, event.last.time, 0.0, {}};
    // Either edge is known to half a spacing; the rest is what the choice of the link length decides.
    measured.uncertainty = target.spacing + std::abs(wide.diameter - narrow.diameter);
    const auto on_line = target.unseen(target.on_line(wide.depth));
    const auto radius = 0.5 * wide.diameter * side_of(target.direction);
    measured.drawing = Segment{on_line - radius, on_line + radius};
    return measured;
  };
  return {take, rim_fields};
}

/// Keys: as above.
Measure read_crater_depth(Section& section, const Declared& declared) {
  const auto find_target = read_target(section, declared, true);
  const auto take = [=](const Event& event) {
    const auto target = find_target(event);
    const auto hangs = hangs_on_rim(event, event.fragments, on_rim(event, target));
    // The wall of a slender channel lies within the support of its axis, so a smoothing length is looked across first.
    const auto wide = floor_within(link_of_support * target.smoothing_length, event, target, hangs);
    if (!wide && !lay_within(link_of_support * target.smoothing_length, event, target))
      throw RunError("the flight line passes the target by: there was nothing of it at the start");
    if (!wide) throw RunError("the target is perforated: its coherent matter leaves the flight line free");
    require_across(event, target, Face::front);
    const auto narrow = floor_within(link_of_smoothing_length * target.smoothing_length, event, target, hangs);
    const double floor = narrow.value_or(*wide) - 0.5 * target.spacing;  // with the matter around the particles
    const double front = target.thickness.low;
    Measured measured{floor - front, event.last.time, 0.0, {}};
    measured.uncertainty = target.spacing + narrow.value_or(*wide) - *wide;
    measured.drawing = Segment{target.unseen(target.on_line(front)), target.unseen(target.on_line(floor))};
    return measured;
  };
  return {take, rim_fields};
}

}  // namespace tektite
