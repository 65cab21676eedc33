// The diameter of the crater or hole that a projectile leaves in a target.
//
// Around the flight line, the matter of the coherent target is compared with what was there at the start, ring by ring
// (in the plane: in pairs of strips). The edge is the innermost ring that is half full again, as on a radiograph: a
// strand of particles in front of a torn wall does not decide the diameter, and the distance between the quarter-full
// and the three-quarters-full ring tells how sharp the edge is. Where the target is perforated, matter counts over the
// whole original thickness; where it is not, in one spacing at the original front surface. What has left the original
// thickness (lips, bulges) does not count, and neither do loose fragments: the coherent target is what still hangs on
// the rim, its outermost tenth. The target's surface is taken to lie across the flight line (normal impact).

#include <algorithm>
#include <cmath>

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

/// Mass per ring around the flight line.
class Profile {
 public:
  /// Rings are a quarter of a spacing wide.
  explicit Profile(double spacing) : spacing_(spacing), width_(0.25 * spacing) {}

  /// A particle's matter reaches half a spacing to either side of its place.
  void add(double radius, double mass) {
    const double low = std::max(0.0, radius - 0.5 * spacing_);
    const double high = radius + 0.5 * spacing_;
    const auto last = static_cast<std::size_t>(high / width_);
    if (rings_.size() <= last) rings_.resize(last + 1, 0.0);
    for (auto k = static_cast<std::size_t>(low / width_); k <= last; ++k) {
      const double begin = std::max(low, width_ * static_cast<double>(k));
      const double end = std::min(high, width_ * static_cast<double>(k + 1));
      rings_[k] += mass * std::max(0.0, end - begin) / (high - low);
    }
  }

  /// The innermost radius at which this profile holds the share `part` of `before`; throws RunError where none does.
  double edge(const Profile& before, double part) const {
    for (std::size_t k = 0; k < std::min(rings_.size(), before.rings_.size()); ++k)
      if (before.rings_[k] > 0.0 && rings_[k] >= part * before.rings_[k]) return width_ * static_cast<double>(k);
    throw RunError("the coherent target has left its original place");
  }

 private:
  double spacing_;
  double width_;
  std::vector<double> rings_;
};

/// Profile of the particles that `chosen(i)` picks within a layer.
template <class Chosen>
Profile profile_of(const Whole& whole, const View& view, const Extent& depth, const Chosen& chosen) {
  Profile profile(view.spacing);
  for (std::size_t i = 0; i < whole.count(); ++i) {
    const double along = dot(whole.position[i], view.direction);
    if (chosen(i) && along >= depth.low && along <= depth.high)
      profile.add(norm(view.across(whole.position[i])), whole.mass[i]);
  }
  return profile;
}

struct Crater {
  double diameter;
  double blur;   ///< between the diameters at which the target is a quarter and three quarters full
  double depth;  ///< along the direction, where it is drawn
};

Crater crater_of(const Event& event, const Fragments& fragments, std::int32_t target, const View& view) {
  const auto hangs = hangs_on_rim(event, fragments, target, view);
  const auto opening_in = [&](const Extent& layer, double where) {
    const auto before =
        profile_of(event.initial, view, layer, [&](std::size_t i) { return event.initial.body[i] == target; });
    const auto now = profile_of(event.last, view, layer, [&](std::size_t i) { return hangs[fragments.label[i]]; });
    return Crater{2.0 * now.edge(before, 0.5), 2.0 * (now.edge(before, 0.75) - now.edge(before, 0.25)), where};
  };
  const auto& thickness = view.thickness;
  const auto through = opening_in(thickness, 0.5 * (thickness.low + thickness.high));
  // An opening below two spacings is the play between particles, not a hole.
  if (through.diameter > 2.0 * view.spacing) return through;
  return opening_in({thickness.low, thickness.low + view.spacing}, thickness.low);
}

/// A unit vector across the flight, in the plane of a plane scene.
Point side_of(const View& view) {
  const auto& n = view.direction;
  const double length = std::hypot(n[0], n[1]);
  if (length < 0.5) return {1.0, 0.0, 0.0};  // flight along z, up to 30 degrees
  return {-n[1] / length, n[0] / length, 0.0};
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
    Measured measured{wide.diameter, event.last.time, 0.0, {}};
    // Either edge is known to half a spacing and is as blurred as the profile tells; the rest is what the choice of the
    // link length decides.
    measured.uncertainty = view.spacing + 0.5 * wide.blur + std::abs(wide.diameter - narrow.diameter);
    const auto on_line = view.centre + (wide.depth - dot(view.centre, view.direction)) * view.direction;
    const auto radius = 0.5 * wide.diameter * side_of(view);
    measured.drawing = Segment{on_line - radius, on_line + radius};
    return measured;
  };
}

}  // namespace tektite
