// The volume of a solid on one side of symmetry planes. By the divergence theorem a volume is the sum of the signed
// tetrahedra over its surface from any apex. With the apex in all planes at once, the faces that the cuts would open
// have no height and add nothing: so only the triangles need cutting, and the cut solid is never built.

#include "preprocess/geometry/surface_mesh.hpp"

namespace tektite::preprocess {
namespace {

using Corners = std::vector<Point>;

double height(const SymmetryPlane& plane, const Point& p) { return plane.side * (p[plane.axis] - plane.at); }

/// Sutherland and Hodgman: the part of a convex polygon on the kept side.
Corners cut(const Corners& corners, const SymmetryPlane& plane) {
  Corners kept;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& a = corners[k];
    const auto& b = corners[(k + 1) % corners.size()];
    const double above_a = height(plane, a), above_b = height(plane, b);
    if (above_a >= 0.0) kept.push_back(a);
    if ((above_a > 0.0 && above_b < 0.0) || (above_a < 0.0 && above_b > 0.0))
      kept.push_back(a + (above_a / (above_a - above_b)) * (b - a));
  }
  return kept;
}

double tetrahedron(const Point& a, const Point& b, const Point& c) {
  return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
          a[2] * (b[0] * c[1] - b[1] * c[0])) /
         6.0;
}

}  // namespace

double Surface::volume_within(std::span<const SymmetryPlane> planes) const {
  Point apex{};
  for (const auto& plane : planes) apex[plane.axis] = plane.at;
  const auto& mesh = mesh_->triangles;
  double volume = 0.0;
  for (const auto face : mesh.faces()) {
    Corners corners;
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
      const auto& p = mesh.point(vertex);
      corners.push_back({p.x(), p.y(), p.z()});
    }
    for (const auto& plane : planes) corners = cut(corners, plane);
    for (std::size_t k = 2; k < corners.size(); ++k)
      volume += tetrahedron(corners[0] - apex, corners[k - 1] - apex, corners[k] - apex);
  }
  return volume;
}

}  // namespace tektite::preprocess
