// What comes out behind a plate: the projectile (the debris) and the plug that it has punched out. The plug is the
// largest connected piece of the plate ahead of the debris: one that no longer hangs on the plate's rim, whose centre
// of mass lies ahead of that of the coherent debris and which reaches farther than the debris does. However small, it
// counts: where the plate went to crumbs, the plug is a crumb, the foremost of the heaviest. Where nothing flies ahead,
// there is no plug to measure. Source: G. Young, F. Teixeira-Dias, L. Azevedo, J. Mill (2021), Int. J. Mech. Sci. 192,
// 106108, table 2.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/error.hpp"
#include "postprocess/measure/target.hpp"

namespace tektite {
namespace {

/// How far the foremost particle of each fragment reaches along a direction.
std::vector<double> fronts_of(const Whole& whole, const Fragments& fragments, const Point& direction) {
  std::vector<double> front(fragments.list.size(), -limits::infinite);
  for (std::size_t i = 0; i < whole.count(); ++i)
    front[fragments.label[i]] = std::max(front[fragments.label[i]], dot(whole.position[i], direction));
  return front;
}

/// Index of the plug in the list of fragments; nullopt where there is none. Of equally heavy pieces, as single failed
/// particles are, it is the foremost: which of them comes first in the list depends on how the scene stands in its
/// axes.
std::optional<std::uint32_t> find_plug(const Event& event, const Fragments& fragments, const Target& target) {
  constexpr double equal = 1.0 - 1e-9;  // of masses that were added up in another order
  const auto hangs = hangs_on_rim(event, fragments, on_rim(event, target));
  const auto front = fronts_of(event.last, fragments, target.direction);
  const auto debris = fragments.heaviest(target.projectile);
  const auto at = [&](std::uint32_t k) { return dot(fragments.list[k].centre, target.direction); };
  std::optional<std::uint32_t> plug;
  for (std::uint32_t k = 0; k < fragments.list.size(); ++k) {  // the heaviest of a body comes first
    if (fragments.list[k].body != target.body || hangs[k]) continue;
    if (plug && fragments.list[k].mass < equal * fragments.list[*plug].mass) break;
    const bool ahead = at(k) > at(debris) && front[k] > front[debris];
    if (ahead && (!plug || at(k) > at(*plug))) plug = k;
  }
  return plug;
}

std::uint32_t plug_of(const Event& event, const Target& target) {
  const auto plug = find_plug(event, event.fragments, target);
  if (!plug) throw RunError("there is no plug: no piece of the target flies ahead of the projectile");
  return *plug;
}

/// Velocity of a fragment's centre of mass along the direction. Whether the outermost layer belongs to the piece is
/// open by half a spacing at either end: as much of the spread of velocities within it (one standard deviation) as that
/// is of its length is the uncertainty.
Measured velocity_along(const Event& event, std::uint32_t fragment, const Point& direction) {
  const auto& whole = event.last;
  const auto& fragments = event.fragments;
  const auto belongs = [&](std::size_t i) { return fragments.label[i] == fragment; };
  const auto& piece = fragments.list[fragment];
  const double velocity = dot(piece.velocity, direction);
  double square = 0.0;
  for (std::size_t i = 0; i < whole.count(); ++i)
    if (belongs(i)) square += whole.mass[i] * std::pow(dot(whole.velocity[i], direction) - velocity, 2);
  const double spacing = whole.bodies[static_cast<std::size_t>(piece.body)].spacing;
  const double share = spacing / extent_along(whole, direction, belongs).length();
  return {velocity, whole.time, share * std::sqrt(square / piece.mass), {}};
}

struct Width {
  double value = 0.0;
  Point side = Point::zero();  ///< unit vector along which it is measured
  double middle = 0.0;         ///< along that side
};

/// The largest extent of a fragment across the flight, between the centres of its outermost particles. In space it is
/// looked for degree by degree: half a degree off, it falls short by less than a ten-thousandth.
Width width_of(const Whole& whole, const Fragments& fragments, std::uint32_t fragment, const Point& direction) {
  const Sectors sectors(direction, whole.dimensions);
  const int turns = whole.dimensions == 2 ? 1 : 180;
  Width widest;
  widest.side = sectors.first();
  widest.middle = dot(fragments.list[fragment].centre, widest.side);
  std::vector<Point> places;
  for (std::size_t i = 0; i < whole.count(); ++i)
    if (fragments.label[i] == fragment) places.push_back(whole.position[i]);
  for (int turn = 0; turn < turns; ++turn) {
    const double angle = turn * std::numbers::pi / turns;
    const auto side = std::cos(angle) * sectors.first() + std::sin(angle) * sectors.second();
    Extent extent{limits::infinite, -limits::infinite};
    for (const auto& place : places) {
      extent.low = std::min(extent.low, dot(place, side));
      extent.high = std::max(extent.high, dot(place, side));
    }
    if (extent.length() > widest.value) widest = {extent.length(), side, 0.5 * (extent.low + extent.high)};
  }
  return widest;
}

}  // namespace

/// Velocity along its flight of the coherent body that `body` names, in the last snapshot. Keys: body, axis.
Measure read_debris_velocity(Section& section, const Declared& declared) {
  const auto name = read_body(section, "body", declared);
  const auto axis = read_axis(section, declared.space);
  return [=](const Event& event) {
    const auto body = event.initial.body_named(name);
    const auto direction = flight_direction(event.initial, body, axis);
    auto measured = velocity_along(event, event.fragments.heaviest(body), direction);
    const auto& narrow = event.narrow_fragments.list[event.narrow_fragments.heaviest(body)];
    measured.uncertainty += std::abs(measured.value - dot(narrow.velocity, direction));
    return measured;
  };
}

/// Velocity of the plug along the flight of the projectile. Keys: body (the target), projectile, axis.
Measure read_plug_velocity(Section& section, const Declared& declared) {
  const auto find_target = read_target(section, declared, false);
  const auto take = [=](const Event& event) {
    const auto target = find_target(event);
    auto measured = velocity_along(event, plug_of(event, target), target.direction);
    if (const auto narrow = find_plug(event, event.narrow_fragments, target))
      measured.uncertainty +=
          std::abs(measured.value - dot(event.narrow_fragments.list[*narrow].velocity, target.direction));
    return measured;
  };
  return {take, rim_fields};
}

/// Largest extent of the plug across the flight, between centres of particles, as all lengths of that table are: 0
/// where the plug is a single particle. Keys: body (the target), projectile, axis.
Measure read_plug_width(Section& section, const Declared& declared) {
  const auto find_target = read_target(section, declared, true);
  const auto take = [=](const Event& event) {
    const auto target = find_target(event);
    const auto plug = plug_of(event, target);
    const auto wide = width_of(event.last, event.fragments, plug, target.direction);
    const auto narrow_plug = find_plug(event, event.narrow_fragments, target);
    const auto narrow =
        narrow_plug ? width_of(event.last, event.narrow_fragments, *narrow_plug, target.direction) : Width{};
    Measured measured{wide.value, event.last.time, 0.0, {}};
    // Matter reaches half a spacing beyond the outermost centres; the rest is what the choice of the link decides.
    measured.uncertainty = target.spacing + std::abs(wide.value - narrow.value);
    const auto centre = event.fragments.list[plug].centre;
    const auto middle = centre + (wide.middle - dot(centre, wide.side)) * wide.side;
    measured.drawing = Segment{middle - 0.5 * wide.value * wide.side, middle + 0.5 * wide.value * wide.side};
    return measured;
  };
  return {take, rim_fields};
}

}  // namespace tektite
