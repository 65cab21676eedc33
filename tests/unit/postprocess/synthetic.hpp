#pragma once
// Runs made by hand: a disc that has passed through a plate, in any orientation, whole or as a half with a symmetry
// plane. Lengths in metres; the spacing is 1 mm.

#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/snapshot.hpp"
#include "postprocess/measure/measure.hpp"

namespace tektite::test {

inline constexpr double spacing = 1e-3;

/// What is done to every vector of a scene that was made for flight along +x.
using Turn = std::function<Point(const Point&)>;

inline Point as_it_is(const Point& a) { return a; }
inline Point turned_by_90_degrees(const Point& a) { return {-a[1], a[0], a[2]}; }
inline Point turned_by_30_degrees(const Point& a) {
  const double c = std::sqrt(0.75);
  return {c * a[0] - 0.5 * a[1], 0.5 * a[0] + c * a[1], a[2]};
}
inline Point mirrored(const Point& a) { return {-a[0], a[1], a[2]}; }

struct Placed {
  std::string body;
  Point position;
  Point velocity;
};

inline Snapshot snapshot_of(Space space, const std::vector<Placed>& placed, double time, const std::string& scene,
                            const Turn& turn) {
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (bodies.empty() || bodies.back().name != placed[i].body)
      bodies.push_back({placed[i].body, "aluminium", spacing, {i, i}});
    bodies.back().range.end = i + 1;
  }
  Snapshot snapshot{Particles(space, bodies), {{"time", time}}, scene};
  auto& particles = snapshot.particles;
  const int width = particles.dimensions();
  for (const auto field : {Field::id, Field::position, Field::velocity, Field::mass, Field::density,
                           Field::smoothing_length, Field::pressure, Field::plastic_strain, Field::sound_speed})
    particles.allocate(field);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const auto position = turn(placed[i].position);
    const auto velocity = turn(placed[i].velocity);
    for (int k = 0; k < width; ++k) {
      particles.scalars(Field::position)[i * static_cast<std::size_t>(width) + static_cast<std::size_t>(k)] =
          position[k];
      particles.scalars(Field::velocity)[i * static_cast<std::size_t>(width) + static_cast<std::size_t>(k)] =
          velocity[k];
    }
    particles.integers(Field::id)[i] = static_cast<std::int64_t>(i);
    particles.scalars(Field::mass)[i] = 2785.0 * std::pow(spacing, width);
    particles.scalars(Field::density)[i] = 2785.0;
    particles.scalars(Field::smoothing_length)[i] = 1.4 * spacing;
    particles.scalars(Field::pressure)[i] = 1e9 * std::sin(300.0 * placed[i].position[1]);
    particles.scalars(Field::plastic_strain)[i] = std::abs(placed[i].position[0]) * 10.0;
    particles.scalars(Field::sound_speed)[i] = 5000.0;
  }
  return snapshot;
}

/// The event as an observer sees it who moves with `velocity` the other way.
inline Event carried_along(Event event, const Point& velocity) {
  const auto way = (event.last.time - event.initial.time) * velocity;
  for (auto* state : {&event.initial, &event.last})
    for (auto& of_particle : state->velocity) of_particle += velocity;
  for (auto& place : event.last.position) place += way;
  event.fragments = find_fragments(event.last, link_of_support);
  event.narrow_fragments = find_fragments(event.last, link_of_smoothing_length);
  return event;
}

/// What a measure takes of the event, of whose last snapshot it gets no field that it does not declare.
inline Measured taken(const NamedMeasure& named, Event event) {
  for (const auto& row : field_table)
    if (!named.measure.fields.contains(row.field)) event.last_snapshot.particles.release(row.field);
  return named.measure(event);
}

/// How the run below ends.
struct Ending {
  double hole = 0.0;           ///< diameter that is cut out of the plate
  double pit = 0.0;            ///< diameter of a pit in the front half of the plate
  double projectile_at = 0.0;  ///< where the centre of the disc is
  bool crumbs = false;         ///< particles far ahead of and behind the disc, and in the hole
};

/// A disc of radius 5 mm that flies along +x, its front 1 mm before a plate of 2 mm x 40 mm (x 40 mm in space) at x =
/// 0; `half` leaves out what lies below y = 0.
inline std::vector<Placed> impact(Space space, const Ending* ending, bool half) {
  const bool solid = space == Space::solid;
  const double speed = 1000.0;
  std::vector<Placed> placed;
  const auto each = [&](double x0, double x1, double r, const auto& visit) {
    for (double x = x0 + 0.5 * spacing; x < x1; x += spacing)
      for (double y = (half ? 0.5 : -std::round(r / spacing) + 0.5) * spacing; y < r; y += spacing)
        for (double z = solid ? (-std::round(r / spacing) + 0.5) * spacing : 0.0; z < (solid ? r : 0.5 * spacing);
             z += spacing)
          visit(Point{x, y, z});
  };
  const double centre = -6e-3;
  const double moved = ending ? ending->projectile_at - centre : 0.0;
  each(-11e-3, -1e-3, 5e-3, [&](const Point& x) {
    if (std::hypot(x[0] - centre, x[1], x[2]) > 5e-3) return;
    auto at = x;
    at[0] += moved;
    // Two crumbs, which half models have too: the one that was highest flies ahead, the foremost one stays behind.
    if (ending && ending->crumbs && std::abs(x[1]) > 4.4e-3 && x[0] < centre) at[0] += 60e-3;
    placed.push_back({"projectile", at, {speed, 0.0, 0.0}});
  });
  each(0.0, 2e-3, 20e-3, [&](const Point& x) {
    auto at = x;
    const double radius = std::hypot(x[1], x[2]);
    const bool in_hole = ending && radius < 0.5 * ending->hole;
    const bool in_pit = ending && radius < 0.5 * ending->pit && x[0] < 1e-3;
    // What is knocked out flies off, each particle on its own; some of it hangs in the hole as loose crumbs.
    if (in_hole || in_pit) at[0] += 0.1 + 20.0 * radius;
    if (in_hole && ending->crumbs && radius < 0.8e-3) at = x;
    placed.push_back({"target", at, {0.0, 0.0, 0.0}});
  });
  return placed;
}

inline std::string scene_text(Space space, bool half) {
  std::string text =
      "name = \"made_by_hand\"\ntitle = \"Disc through a plate\"\nspace = \"" + std::string(name_of(space)) + "\"\n";
  if (half) text += "[symmetry.middle]\naxis = \"y\"\n";
  text +=
      "[body.projectile]\nmaterial = \"aluminium\"\n[body.target]\nmaterial = \"aluminium\"\n"
      "[probe.centre]\nbody = \"projectile\"\nposition = [0, 0]\nfields = [\"pressure\"]\n"
      "[measure.peak_pressure]\nprobe = \"centre\"\n[measure.peak_tension]\nprobe = \"centre\"\n";
  if (space != Space::line)
    text +=
        "[measure.crater_diameter]\nbody = \"target\"\n[measure.crater_depth]\nbody = \"target\"\n"
        "[measure.projectile_extension]\nbody = \"projectile\"\n"
        "[measure.projectile_travel]\nbody = \"projectile\"\n[measure.max_plastic_strain]\nbody = \"target\"\n";
  return text;
}

}  // namespace tektite::test
