// How thick the projectile is in the end, and how far it came. Both are of the coherent projectile: spalled particles
// fly far ahead of it and behind it, and connectivity leaves them out.

#include <cmath>

#include "core/error.hpp"
#include "postprocess/measure/flight.hpp"

namespace tektite {
namespace {

Extent coherent_extent(const Whole& whole, const Fragments& fragments, std::int32_t body, const Point& direction) {
  const auto coherent = fragments.heaviest(body);
  return extent_along(whole, direction, [&](std::size_t i) { return fragments.label[i] == coherent; });
}

/// The same on the flight line through the piece's centre of mass: of the particles whose support holds the line.
Extent extent_on_line(const Whole& whole, const Fragments& fragments, std::int32_t body, const Point& direction) {
  const auto coherent = fragments.heaviest(body);
  const auto centre = fragments.list[coherent].centre;
  return extent_along(whole, direction, [&](std::size_t i) {
    if (fragments.label[i] != coherent) return false;
    const auto apart = whole.position[i] - centre;
    const auto across = apart - dot(apart, direction) * direction;
    return norm(across) < link_of_support * whole.smoothing_length[i];
  });
}

/// A segment along the flight line between two positions on it.
Segment along_flight(const Point& through, const Point& direction, double from, double to) {
  const double here = dot(through, direction);
  return {through + (from - here) * direction, through + (to - here) * direction};
}

struct Flight {
  std::int32_t body;
  double spacing;
  Point direction;
  Extent wide;    ///< linked over the support of the kernel
  Extent narrow;  ///< linked over one smoothing length
};

Flight final_flight(const Event& event, const std::string& name, const std::optional<Point>& axis) {
  Flight flight;
  flight.body = event.initial.body_named(name);
  flight.spacing = event.initial.bodies[static_cast<std::size_t>(flight.body)].spacing;
  flight.direction = flight_direction(event.initial, flight.body, axis);
  flight.wide = coherent_extent(event.last, event.fragments, flight.body, flight.direction);
  flight.narrow = coherent_extent(event.last, event.narrow_fragments, flight.body, flight.direction);
  return flight;
}

}  // namespace

/// Extension of the coherent projectile in the last snapshot: its thickness on the flight line. A rim that is dragged
/// behind a flattened projectile is not thickness; by how much it reaches farther is not part of the uncertainty.
Measure read_projectile_extension(Section& section, const Declared& declared) {
  const auto body = read_body(section, "body", declared);
  const auto axis = read_axis(section, declared.space);
  return [=](const Event& event) {
    const auto flight = final_flight(event, body, axis);
    const auto wide = extent_on_line(event.last, event.fragments, flight.body, flight.direction);
    const auto narrow = extent_on_line(event.last, event.narrow_fragments, flight.body, flight.direction);
    if (!(wide.length() > 0.0)) throw RunError("the coherent projectile has a hole on its flight line");
    Measured measured{wide.length(), event.last.time, 0.0, {}};
    // Either end is known to half a spacing; the rest is what the choice of the link length decides.
    measured.uncertainty = flight.spacing + std::abs(wide.length() - narrow.length());
    const auto centre = event.fragments.list[event.fragments.heaviest(flight.body)].centre;
    measured.drawing = along_flight(centre, flight.direction, wide.low, wide.high);
    return measured;
  };
}

/// Distance of the coherent projectile's leading edge from where that edge was at contact, as who flies along with the
/// other bodies' initial velocity sees it. Until then the projectile flies free, so that place is its initial edge
/// moved by its velocity times the contact time; where no contact was recorded, the way counts from the start.
Measure read_projectile_travel(Section& section, const Declared& declared) {
  const auto body = read_body(section, "body", declared);
  const auto axis = read_axis(section, declared.space);
  return [=](const Event& event) {
    const auto& initial = event.initial;
    const auto flight = final_flight(event, body, axis);
    const auto start =
        extent_along(initial, flight.direction, [&](std::size_t i) { return initial.body[i] == flight.body; });
    const double others = dot(velocity_of_others(initial, flight.body), flight.direction);
    const double speed = dot(mean_velocity(initial, flight.body), flight.direction) - others;
    const double flown = event.contact_time ? speed * (*event.contact_time - initial.time) : 0.0;
    const double carried = others * (event.last.time - initial.time);
    const double at_contact = start.high + flown + carried;
    Measured measured{flight.wide.high - at_contact, event.last.time, 0.0, {}};
    // Both edges are known to half a spacing; the rest is what the choice of the link length decides.
    measured.uncertainty = flight.spacing + std::abs(flight.wide.high - flight.narrow.high);
    const auto centre = centre_of_mass(event.initial, flight.body);
    measured.drawing = along_flight(centre, flight.direction, at_contact, flight.wide.high);
    return measured;
  };
}

}  // namespace tektite
