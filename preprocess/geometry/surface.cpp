#include "preprocess/geometry/surface.hpp"

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <stdexcept>

#include "core/error.hpp"
#include "preprocess/geometry/surface_mesh.hpp"

namespace tektite::preprocess {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Boolean = bool (*)(TriangleMesh&, TriangleMesh&, TriangleMesh&);

std::shared_ptr<const Surface::Mesh> combined(const Surface& a, const Surface& b, Boolean boolean) {
  auto result = std::make_shared<Surface::Mesh>();
  guarded("the boolean of two solids failed", [&] {
    auto first = a.mesh().triangles, second = b.mesh().triangles;
    if (!boolean(first, second, result->triangles))
      throw InputError("the parts of this boolean touch along an edge or in a point only: let them overlap, or apart");
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
  return Surface(combined(*this, other, [](TriangleMesh& a, TriangleMesh& b, TriangleMesh& out) {
    return pmp::corefine_and_compute_union(a, b, out);
  }));
}

Surface Surface::without(const Surface& other) const {
  return Surface(combined(*this, other, [](TriangleMesh& a, TriangleMesh& b, TriangleMesh& out) {
    return pmp::corefine_and_compute_difference(a, b, out);
  }));
}

Surface Surface::common(const Surface& other) const {
  return Surface(combined(*this, other, [](TriangleMesh& a, TriangleMesh& b, TriangleMesh& out) {
    return pmp::corefine_and_compute_intersection(a, b, out);
  }));
}

double Surface::volume() const { return mesh_->triangles.is_empty() ? 0.0 : pmp::volume(mesh_->triangles); }

}  // namespace tektite::preprocess
