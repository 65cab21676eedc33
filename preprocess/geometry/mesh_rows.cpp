#include "preprocess/geometry/mesh_rows.hpp"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "preprocess/geometry/surface_mesh.hpp"

namespace tektite::preprocess {
namespace {

using Primitive = CGAL::AABB_face_graph_triangle_primitive<TriangleMesh>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<MeshKernel, Primitive>>;
using Vertex = MeshKernel::Point_3;
using Facet = MeshKernel::Triangle_3;

/// On which side of the edge u -> v, projected along x, the row lies: exact, and never zero but for an edge that is
/// itself parallel to x. A row through an edge or a corner counts as shifted by (ε, ε²) in (y, z): every edge then
/// decides alike for both of its triangles, so that the crossings of a closed mesh are always even in number.
int side_of_edge(const Vertex& u, const Vertex& v, const MeshKernel::Point_2& row) {
  const auto exact = CGAL::orientation(MeshKernel::Point_2(u.y(), u.z()), MeshKernel::Point_2(v.y(), v.z()), row);
  if (exact != CGAL::COLLINEAR) return exact == CGAL::LEFT_TURN ? 1 : -1;
  if (u.z() != v.z()) return v.z() > u.z() ? -1 : 1;
  if (u.y() != v.y()) return v.y() > u.y() ? 1 : -1;
  return 0;
}

bool crossed(const Facet& facet, const MeshKernel::Point_2& row) {
  const int first = side_of_edge(facet[0], facet[1], row);
  return first != 0 && first == side_of_edge(facet[1], facet[2], row) && first == side_of_edge(facet[2], facet[0], row);
}

/// Where a row that crosses the facet does so, as x.
double crossing(const Facet& facet, const MeshKernel::Point_2& row) {
  double weighted = 0.0, total = 0.0;
  for (int k = 0; k < 3; ++k) {
    const auto &u = facet[(k + 1) % 3], &v = facet[(k + 2) % 3];
    const double weight = (u.y() - row.x()) * (v.z() - row.y()) - (u.z() - row.y()) * (v.y() - row.x());
    weighted += weight * facet[k].x();
    total += weight;
  }
  const auto [least, most] = std::minmax({facet[0].x(), facet[1].x(), facet[2].x()});
  return total == 0.0 ? 0.5 * (least + most) : std::clamp(weighted / total, least, most);
}

/// The first index whose x is not smaller than `x`, within the row.
std::size_t index_from(const Row& row, double x) {
  const double k = std::ceil((x - row.start[0]) / row.step[0]);
  return static_cast<std::size_t>(std::clamp(k, 0.0, static_cast<double>(row.count)));
}

/// Points within the tolerance of a facet belong to the grown shape, and do not belong to the shrunk one.
void mark_surface(const Row& row, const Facet& facet, double tolerance, std::span<std::uint8_t> inside) {
  const double near = std::abs(tolerance);
  const auto [least, most] = std::minmax({facet[0].x(), facet[1].x(), facet[2].x()});
  for (auto k = index_from(row, least - near); k < index_from(row, most + near); ++k) {
    const auto p = row.at(k);
    if (CGAL::squared_distance(Vertex(p[0], p[1], p[2]), facet) <= near * near) inside[k] = tolerance > 0.0 ? 1 : 0;
  }
}

}  // namespace

struct MeshRows::Tree {
  Surface surface;
  AabbTree facets;
  CGAL::Bbox_3 bounds;
};

MeshRows::MeshRows(const Surface& surface) : tree_(new Tree{surface, {}, {}}) {
  const auto& mesh = tree_->surface.mesh().triangles;
  tree_->facets.insert(faces(mesh).first, faces(mesh).second, mesh);
  tree_->facets.build();
  tree_->bounds = tree_->facets.bbox();
}

MeshRows::~MeshRows() = default;

void MeshRows::mark(const Row& row, double tolerance, std::span<std::uint8_t> inside) const {
  std::fill_n(inside.begin(), row.count, std::uint8_t{0});
  const double near = std::abs(tolerance);
  const MeshKernel::Iso_cuboid_3 path(tree_->bounds.xmin() - near, row.start[1] - near, row.start[2] - near,
                                      std::max(tree_->bounds.xmin(), row.at(row.count)[0]) + near, row.start[1] + near,
                                      row.start[2] + near);
  std::vector<TriangleMesh::Face_index> met;
  tree_->facets.all_intersected_primitives(path, std::back_inserter(met));
  const auto& mesh = tree_->surface.mesh().triangles;
  const MeshKernel::Point_2 place(row.start[1], row.start[2]);
  std::vector<Facet> facets;
  std::vector<double> crossings;
  for (const auto face : met) {
    const auto edge = mesh.halfedge(face);
    facets.emplace_back(mesh.point(mesh.source(edge)), mesh.point(mesh.target(edge)),
                        mesh.point(mesh.target(mesh.next(edge))));
    if (crossed(facets.back(), place)) crossings.push_back(crossing(facets.back(), place));
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t k = 0; k < crossings.size(); k += 2) {  // the last way in has no way out where the row ends inside
    const auto end = k + 1 < crossings.size() ? index_from(row, crossings[k + 1]) : row.count;
    for (auto i = index_from(row, crossings[k]); i < end; ++i) inside[i] = 1;
  }
  for (const auto& facet : facets) mark_surface(row, facet, tolerance, inside);
}

}  // namespace tektite::preprocess
