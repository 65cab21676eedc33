#pragma once
// A sphere of 12 mm that has gone through a plate of 100 mm x 100 mm x 3 mm along +x, made by hand at 1 mm spacing: a
// plug flies ahead of it, crumbs ahead of the plug, and what surrounded the plug is bent forward at a right angle, as a
// lip. Lengths in metres.

#include "postprocess/plan.hpp"
#include "unit/postprocess/synthetic.hpp"

namespace tektite::test {

struct Plate {
  double plug_radius = 4.2e-3;  ///< what lay within it is punched out
  double bend_radius = 8.5e-3;  ///< what lay between the two is the lip
  double plug_at = 60e-3;       ///< how far the plug has moved
  double debris_at = 30e-3;     ///< where the sphere's centre is
  bool crumbs = true;
  bool clamped = true;  ///< whether the run says which particles are clamped
  bool quarter = false;
  Turn turn = as_it_is;
};

/// Impact diameter of the lip: the free edge is bent at a right angle about the plate's exit face, so it reaches from
/// the bend radius to a plate thickness within it; its mean radius is that of the middle layer.
inline double diameter_of_lip(const Plate& plate) { return 2.0 * (plate.bend_radius - 1.5e-3); }

/// The particle of the plate that lay at `x`, in the end.
inline Placed moved(const Plate& plate, const Point& x) {
  const double radius = std::hypot(x[1], x[2]);
  if (plate.crumbs && radius < 0.8e-3 && x[0] > 2e-3)
    return {"plate", {x[0] + 0.1 + 10.0 * (x[1] + 2.0 * x[2]), x[1], x[2]}, {450.0, 0.0, 0.0}};
  if (radius < plate.plug_radius) return {"plate", {x[0] + plate.plug_at, x[1], x[2]}, {373.0, 0.0, 0.0}};
  if (radius > plate.bend_radius) return {"plate", x, Point::zero()};
  const double bent = (plate.bend_radius + x[0] - 3e-3) / radius;
  return {"plate", {3e-3 + plate.bend_radius - radius, bent * x[1], bent * x[2]}, Point::zero()};
}

/// The particles at the start, or in the end.
inline std::vector<Placed> particles_of(const Plate& plate, bool at_start) {
  std::vector<Placed> placed;
  const auto each = [&](double x0, double x1, double r, const auto& visit) {
    const double least = plate.quarter ? 0.0 : -r;
    for (double x = x0 + 0.5 * spacing; x < x1; x += spacing)
      for (double y = least + 0.5 * spacing; y < r; y += spacing)
        for (double z = least + 0.5 * spacing; z < r; z += spacing) visit(Point{x, y, z});
  };
  const double centre = -7.5e-3;
  each(-13.5e-3, -1.5e-3, 6e-3, [&](const Point& x) {
    if (std::hypot(x[0] - centre, x[1], x[2]) > 6e-3) return;
    if (at_start)
      placed.push_back({"debris", x, {500.0, 0.0, 0.0}});
    else
      placed.push_back({"debris", {x[0] - centre + plate.debris_at, x[1], x[2]}, {257.0, 0.0, 0.0}});
  });
  each(0.0, 3e-3, 50e-3, [&](const Point& x) {
    placed.push_back(at_start ? Placed{"plate", x, Point::zero()} : moved(plate, x));
  });
  return placed;
}

inline std::string plate_scene(bool quarter) {
  std::string text = "name = \"plate\"\ntitle = \"Sphere through a plate\"\nspace = \"solid\"\n";
  if (quarter) text += "[symmetry.y]\naxis = \"y\"\n[symmetry.z]\naxis = \"z\"\n";
  text += "[body.debris]\nmaterial = \"steel\"\n[body.plate]\nmaterial = \"aluminium\"\n";
  text += "[measure.debris_velocity]\nbody = \"debris\"\n";
  for (const auto* name : {"plug_velocity", "plug_width", "impact_diameter", "lip_height", "min_neighbour_distance"})
    text += "[measure." + std::string(name) + "]\nbody = \"plate\"\n";
  return text;
}

/// The state at the start or in the end, with a kernel type (all total-Lagrangian), damage (none) and, where that is
/// asked for, the outermost layer of the plate's edges clamped.
inline Snapshot plate_snapshot(const Plate& plate, bool at_start) {
  const auto start = particles_of(plate, true);
  auto snapshot = snapshot_of(Space::solid, at_start ? start : particles_of(plate, false), at_start ? 0.0 : 153e-6,
                              plate_scene(plate.quarter), plate.turn);
  for (const auto field : {Field::kernel_type, Field::damage}) snapshot.particles.allocate(field);
  if (plate.clamped) {
    snapshot.particles.allocate(Field::clamped);
    const auto clamped = snapshot.particles.integers(Field::clamped);
    for (std::size_t i = 0; i < start.size(); ++i)
      clamped[i] = std::abs(start[i].position[1]) > 49e-3 || std::abs(start[i].position[2]) > 49e-3 ? 1 : 0;
  }
  return snapshot;
}

/// The event of these two states.
inline Event event_between(const Snapshot& first, Snapshot last, const std::vector<SymmetryPlane>& planes) {
  Event event;
  event.initial = make_whole(first, planes);
  event.last = make_whole(last, planes);
  event.last_snapshot = std::move(last);
  event.fragments = find_fragments(event.last, link_of_support);
  event.narrow_fragments = find_fragments(event.last, link_of_smoothing_length);
  event.symmetry = planes;
  return event;
}

inline Event event_of(const Plate& plate) {
  auto document = Document::parse(plate_scene(plate.quarter), "scene.toml");
  return event_between(plate_snapshot(plate, true), plate_snapshot(plate, false), read_plan(document).scene.symmetry);
}

/// Takes the measure `name` of the scene.
inline Measured take_of(const std::string& scene, const std::string& name, const Event& event) {
  auto document = Document::parse(scene, "scene.toml");
  for (const auto& measure : read_plan(document).measures)
    if (measure.name == name) return taken(measure, event);
  throw std::logic_error("no measure " + name);
}

}  // namespace tektite::test
