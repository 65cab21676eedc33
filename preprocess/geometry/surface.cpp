#include "preprocess/geometry/surface.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <vector>

#include "core/error.hpp"
#include "preprocess/geometry/surface_mesh.hpp"

namespace tektite::preprocess {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactTriangles = CGAL::Surface_mesh<ExactKernel::Point_3>;
using Boolean = bool (*)(ExactTriangles&, ExactTriangles&, ExactTriangles&);

template <class To, class From, class Convert>
To converted(const From& from, const Convert& convert) {
  To to;
  std::vector<typename To::Vertex_index> places(from.num_vertices());
  for (const auto vertex : from.vertices()) places[vertex] = to.add_vertex(convert(from.point(vertex)));
  for (const auto face : from.faces()) {
    std::vector<typename To::Vertex_index> corners;
    for (const auto vertex : from.vertices_around_face(from.halfedge(face))) corners.push_back(places[vertex]);
    to.add_face(corners);
  }
  return to;
}

}  // namespace

struct ExactMesh {
  ExactTriangles triangles;
};

namespace {

ExactTriangles exact_triangles(const Surface::Mesh& mesh) {
  if (mesh.exact) return mesh.exact->triangles;
  return converted<ExactTriangles>(mesh.triangles,
                                   [](const auto& p) { return ExactKernel::Point_3(p.x(), p.y(), p.z()); });
}

/// Corefinement in exact arithmetic: faces that lie in one plane, or corners that lie on a face, are the rule in scenes
/// and not the exception, and rounded intersections do not survive them.
std::shared_ptr<const Surface::Mesh> combined(const Surface& a, const Surface& b, Boolean boolean) {
  auto result = std::make_shared<Surface::Mesh>();
  guarded("the boolean of two solids failed", [&] {
    auto first = exact_triangles(a.mesh()), second = exact_triangles(b.mesh());
    auto exact = std::make_shared<ExactMesh>();
    if (!boolean(first, second, exact->triangles))
      throw InputError("the parts of this boolean touch along an edge or in a point only: let them overlap, or apart");
    exact->triangles.collect_garbage();
    result->triangles = converted<TriangleMesh>(exact->triangles, [](const auto& p) {
      return MeshKernel::Point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    });
    result->exact = exact;
  });
  return result;
}

}  // namespace

void guarded(const std::string& what, const std::function<void()>& work) {
  static const auto previous = CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  static_cast<void>(previous);
  try {
    work();
  } catch (const CGAL::Failure_exception& fault) {
    throw InputError(what + ": " + fault.expression());
  }
}

Surface Surface::joined(const Surface& other) const {
  return Surface(combined(*this, other, [](ExactTriangles& a, ExactTriangles& b, ExactTriangles& out) {
    return pmp::corefine_and_compute_union(a, b, out);
  }));
}

Surface Surface::without(const Surface& other) const {
  return Surface(combined(*this, other, [](ExactTriangles& a, ExactTriangles& b, ExactTriangles& out) {
    return pmp::corefine_and_compute_difference(a, b, out);
  }));
}

Surface Surface::common(const Surface& other) const {
  return Surface(combined(*this, other, [](ExactTriangles& a, ExactTriangles& b, ExactTriangles& out) {
    return pmp::corefine_and_compute_intersection(a, b, out);
  }));
}

double Surface::volume() const { return mesh_->triangles.is_empty() ? 0.0 : pmp::volume(mesh_->triangles); }

}  // namespace tektite::preprocess
