#pragma once
// CGAL's types behind Surface, for the few files that work on triangles.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <functional>
#include <memory>
#include <string>

#include "preprocess/geometry/surface.hpp"

namespace tektite::preprocess {

using MeshKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using TriangleMesh = CGAL::Surface_mesh<MeshKernel::Point_3>;

/// Triangles with coordinates in exact arithmetic; surface.cpp alone looks inside.
struct ExactMesh;

struct Surface::Mesh {
  TriangleMesh triangles;
  std::shared_ptr<const ExactMesh> exact;  ///< of the result of a boolean, so that the next one meets no rounding
};

/// Runs work on CGAL's behalf: a precondition that CGAL finds violated becomes an InputError with `what` went wrong,
/// and nothing of CGAL's own is printed.
void guarded(const std::string& what, const std::function<void()>& work);

}  // namespace tektite::preprocess
