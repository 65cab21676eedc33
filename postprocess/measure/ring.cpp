// A ring that collapses: its radii, and how round it stays.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <vector>

#include "core/error.hpp"
#include "postprocess/measure/moment.hpp"

namespace tektite {
namespace {

enum class Face { inner, outer };

/// Radii of the particles of a face: those that start within half a spacing of the least or largest radius.
struct Radii {
  double initial = 0.0;  ///< their mean at the start
  double least = limits::infinite, largest = 0.0, mean = 0.0;
  double step = 0.0;  ///< the largest change from one particle to the next around the centre
};

/// Where a particle of a face is.
struct Polar {
  double angle, radius;
  auto operator<=>(const Polar&) const = default;  // NOLINT(modernize-use-nullptr): clang-tidy 14 misreads it
};

Radii radii_of(const Event& event, const Whole& now, std::int32_t body, const Point& centre, Face face) {
  const double half = 0.5 * event.initial.bodies[static_cast<std::size_t>(body)].spacing;
  const double sign = face == Face::inner ? 1.0 : -1.0;
  double first = limits::infinite;
  for (std::size_t i = 0; i < event.initial.count(); ++i)
    if (event.initial.body[i] == body) first = std::min(first, sign * norm(event.initial.position[i] - centre));
  const auto place = places_in(event.initial, now);
  Radii radii;
  std::vector<Polar> face_points;
  for (std::size_t i = 0; i < now.count(); ++i) {
    if (now.body[i] != body) continue;
    const double start = norm(event.initial.position[place[i]] - centre);
    if (sign * start > first + half) continue;
    const double r = norm(now.position[i] - centre);
    radii.initial += start;
    radii.mean += r;
    radii.least = std::min(radii.least, r);
    radii.largest = std::max(radii.largest, r);
    const auto from_centre = now.position[i] - centre;
    face_points.push_back({std::atan2(from_centre[1], from_centre[0]), r});
  }
  const auto count = face_points.size();
  radii.initial /= static_cast<double>(count);
  radii.mean /= static_cast<double>(count);
  std::ranges::sort(face_points);
  for (std::size_t k = 0; k < count; ++k)
    radii.step = std::max(radii.step, std::abs(face_points[k].radius - face_points[(k + 1) % count].radius));
  return radii;
}

/// The keys body, centre and time.
struct Chosen {
  std::string body;
  Point centre = Point::zero();
  std::optional<double> time;
};

Chosen read_chosen(Section& section, const Declared& declared) {
  if (!is_plane(declared.space)) throw section.fault("", "a ring lies in the plane", "plane-strain, plane-stress");
  Chosen chosen{read_body(section, "body", declared), Point::zero(), read_moment(section)};
  if (section.has("centre")) {
    const auto values = section.quantities("centre", dimension::length, 2);
    chosen.centre = {values[0], values[1], 0.0};
  }
  return chosen;
}

/// Radius of the surface beside the outermost particles, which lies half a spacing beyond them at the start and then
/// encloses as much area with them as it did. The uncertainty is the scatter of their radii.
Measure read_radius(Section& section, const Declared& declared, Face face) {
  const auto chosen = read_chosen(section, declared);
  return [=](const Event& event) {
    return measured_at(event, chosen.time, {}, [&](const Snapshot&, const Whole& whole) {
      const auto body = whole.body_named(chosen.body);
      const auto radii = radii_of(event, whole, body, chosen.centre, face);
      const double half = 0.5 * event.initial.bodies[static_cast<std::size_t>(body)].spacing;
      const double surface = radii.initial + (face == Face::inner ? -half : half);
      const double square = radii.mean * radii.mean + surface * surface - radii.initial * radii.initial;
      if (!(square > 0.0)) throw RunError("the ring has closed");
      return Measured{std::sqrt(square), whole.time, 0.5 * (radii.largest - radii.least), {}};
    });
  };
}

}  // namespace

/// Keys: body, centre (the origin), time (the last snapshot; otherwise the nearest one).
Measure read_inner_radius(Section& section, const Declared& declared) {
  return read_radius(section, declared, Face::inner);
}
Measure read_outer_radius(Section& section, const Declared& declared) {
  return read_radius(section, declared, Face::outer);
}

/// Spread of the radii of the innermost particles, largest less least over their mean: zero in a ring that stays round.
/// The surface is seen a spacing apart: each of the two is uncertain by half of the largest change from one particle to
/// the next. Keys as above.
Measure read_symmetry_error(Section& section, const Declared& declared) {
  const auto chosen = read_chosen(section, declared);
  return [=](const Event& event) {
    return measured_at(event, chosen.time, {}, [&](const Snapshot&, const Whole& whole) {
      const auto radii = radii_of(event, whole, whole.body_named(chosen.body), chosen.centre, Face::inner);
      return Measured{(radii.largest - radii.least) / radii.mean, whole.time, radii.step / radii.mean, {}};
    });
  };
}

}  // namespace tektite
