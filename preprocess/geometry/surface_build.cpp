// Surfaces of primitives: boxes, prisms and solids of revolution.

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "preprocess/geometry/surface_mesh.hpp"

namespace tektite::preprocess {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Faces = std::vector<std::vector<std::size_t>>;

/// Polygons that close a volume, each oriented like its neighbours; made outward here.
std::shared_ptr<Surface::Mesh> build(const std::vector<Point>& points, const Faces& faces) {
  auto mesh = std::make_shared<Surface::Mesh>();
  auto& triangles = mesh->triangles;
  guarded("a solid could not be triangulated", [&] {
    std::vector<TriangleMesh::Vertex_index> vertices;
    for (const auto& p : points) vertices.push_back(triangles.add_vertex({p[0], p[1], p[2]}));
    bool whole = true;
    for (const auto& face : faces) {
      std::vector<TriangleMesh::Vertex_index> corners;
      for (const auto k : face) corners.push_back(vertices[k]);
      whole = whole && triangles.add_face(corners) != TriangleMesh::null_face();
    }
    whole = whole && pmp::triangulate_faces(triangles) && CGAL::is_closed(triangles);
    if (!whole)
      throw InputError(
          "the surface of a part touches itself, as where a revolved outline meets its axis with one corner alone: let "
          "an edge of it lie on the axis, or keep it off");
    if (!pmp::is_outward_oriented(triangles)) pmp::reverse_face_orientations(triangles);
  });
  return mesh;
}

std::vector<Point> moved(std::vector<Point> points, const Placement& placement) {
  for (auto& point : points) point = placement.apply(point);
  return points;
}

/// The faces that one edge of the outline sweeps; `ring[i]` holds one index where corner i lies on the axis.
void sweep(const std::vector<std::size_t>& from, const std::vector<std::size_t>& to, Faces& faces) {
  if (from.size() == 1 && to.size() == 1) return;
  for (std::size_t k = 0; k < facets_around; ++k) {
    const std::size_t next = (k + 1) % facets_around;
    if (from.size() == 1)
      faces.push_back({from[0], to[k], to[next]});
    else if (to.size() == 1)
      faces.push_back({from[k], to[0], from[next]});
    else
      faces.push_back({from[k], to[k], to[next], from[next]});
  }
}

}  // namespace

Surface Surface::from_triangles(const std::vector<Point>& points, const std::vector<Triangle>& triangles) {
  Faces faces;
  for (const auto& triangle : triangles) faces.emplace_back(triangle.begin(), triangle.end());
  return Surface(build(points, faces));
}

Surface box_surface(const Point& lower, const Point& upper, const Placement& placement) {
  return prism_surface({{lower[0], lower[1]}, {upper[0], lower[1]}, {upper[0], upper[1]}, {lower[0], upper[1]}},
                       lower[2], upper[2], placement);
}

Surface prism_surface(const std::vector<PlanePoint>& corners, double lower, double upper, const Placement& placement) {
  const std::size_t n = corners.size();
  std::vector<Point> points;
  for (const auto& corner : corners) points.push_back({corner[0], corner[1], lower});
  for (const auto& corner : corners) points.push_back({corner[0], corner[1], upper});
  Faces faces(2);
  for (std::size_t k = 0; k < n; ++k) {
    faces[0].push_back(n - 1 - k);
    faces[1].push_back(n + k);
    faces.push_back({k, (k + 1) % n, n + (k + 1) % n, n + k});
  }
  return Surface(build(moved(points, placement), faces));
}

Surface revolved_surface(const std::vector<PlanePoint>& outline, double volume, const Placement& placement) {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> rings;
  for (const auto& [axial, radial] : outline) {
    auto& ring = rings.emplace_back();
    for (std::size_t k = 0; k < (radial > 0.0 ? facets_around : 1); ++k) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / facets_around;
      ring.push_back(points.size());
      points.push_back({axial, radial * std::cos(angle), radial * std::sin(angle)});
    }
  }
  Faces faces;
  for (std::size_t k = 0; k < rings.size(); ++k) sweep(rings[k], rings[(k + 1) % rings.size()], faces);
  const double scale = std::sqrt(volume / pmp::volume(build(points, faces)->triangles));
  for (auto& point : points) point = {point[0], scale * point[1], scale * point[2]};
  return Surface(build(moved(points, placement), faces));
}

}  // namespace tektite::preprocess
