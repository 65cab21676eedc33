#pragma once
// Closed triangulated surfaces of solids and their exact booleans (CGAL corefinement), from which come the volumes of
// booleans and of bodies that a symmetry plane cuts. Round primitives are triangulated with `facets_around` facets and
// scaled so that the triangulation has their volume exactly; the volume of a part that a plane or another solid cuts
// off is then right to about 1e-4 of the whole (a test holds spheres to that).

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/scene.hpp"
#include "preprocess/geometry/placement.hpp"

namespace tektite::preprocess {

using Triangle = std::array<std::size_t, 3>;
using PlanePoint = std::array<double, 2>;

inline constexpr int facets_around = 128;

class Surface {
 public:
  /// A closed surface; triangles are counter-clockwise seen from outside. Throws InputError where it is not closed.
  static Surface from_triangles(const std::vector<Point>& points, const std::vector<Triangle>& triangles);

  /// Throw InputError where the result touches itself along an edge or in a point only, which is no solid.
  Surface joined(const Surface& other) const;
  Surface without(const Surface& other) const;
  Surface common(const Surface& other) const;
  /// In m³.
  double volume() const;
  /// The volume on the kept side of all these planes, no two of them across one axis, in m³.
  double volume_within(std::span<const SymmetryPlane> planes) const;

  struct Mesh;
  explicit Surface(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)) {}
  const Mesh& mesh() const { return *mesh_; }

 private:
  std::shared_ptr<const Mesh> mesh_;
};

/// A box, moved.
Surface box_surface(const Point& lower, const Point& upper, const Placement& placement);

/// A prism over a polygon in the plane, from z = lower to z = upper, moved.
Surface prism_surface(const std::vector<PlanePoint>& corners, double lower, double upper, const Placement& placement);

/// The solid that the polygon of (axial, radial) points sweeps about the x axis, moved. Points with radius 0 lie on the
/// axis. `volume` (m³) is what the triangulation is scaled to, radially.
Surface revolved_surface(const std::vector<PlanePoint>& outline, double volume, const Placement& placement);

}  // namespace tektite::preprocess
