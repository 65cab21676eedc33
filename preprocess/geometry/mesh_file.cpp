#include "preprocess/geometry/mesh_file.hpp"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/helpers.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "core/apart.hpp"
#include "core/error.hpp"
#include "preprocess/geometry/mesh_format.hpp"
#include "preprocess/geometry/surface_mesh.hpp"

namespace tektite::preprocess {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Corner = MeshKernel::Point_3;

struct Soup {
  std::vector<Corner> points;
  std::vector<std::vector<std::size_t>> polygons;
};

std::string shown(const Corner& p) { return fmt::format("({:g}, {:g}, {:g}) m", p.x(), p.y(), p.z()); }

bool parse(const std::string& path, Soup& soup) {
  return CGAL::IO::read_polygon_soup(path, soup.points, soup.polygons, CGAL::parameters::verbose(false));
}

Soup read_soup(const std::string& path, double metres) {
  check_mesh_format(path);
  Soup soup;
  // CGAL's readers take counts on trust, and do not survive all that a damaged file may say.
  if (!can_be_read(path, [&] { parse(path, soup); }) || !parse(path, soup))
    throw mesh_fault(path, "the mesh cannot be read", "a whole STL, OFF, OBJ or PLY file");
  if (soup.polygons.empty()) throw mesh_fault(path, "the mesh has no faces", "a closed surface");
  for (const auto& polygon : soup.polygons)
    for (const auto corner : polygon)
      if (corner >= soup.points.size())
        throw mesh_fault(path, "a face names a point that is not there", "faces of the points of the file");
  for (auto& p : soup.points) {
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      throw mesh_fault(path, "a coordinate is not a finite number", "finite coordinates");
    p = Corner(metres * p.x(), metres * p.y(), metres * p.z());
  }
  return soup;
}

void repair_soup(Soup& soup, std::vector<std::string>& repairs) {
  const auto say = [&](std::size_t count, const char* what) {
    if (count > 0) repairs.push_back(fmt::format("{} {}", count, what));
  };
  const auto points = soup.points.size();
  say(pmp::merge_duplicate_points_in_polygon_soup(soup.points, soup.polygons), "doubled points stitched");
  const auto merged = points - soup.points.size();
  const auto faces = soup.polygons.size();
  pmp::repair_polygon_soup(soup.points, soup.polygons);
  say(faces - std::min(faces, soup.polygons.size()), "degenerate or doubled faces removed");
  say(points - merged - std::min(points - merged, soup.points.size()), "points without a face removed");
}

/// Every edge must belong to two faces: one is a hole's rim, three or more are no surface of a solid.
void check_edges(const Soup& soup, const std::string& path) {
  std::vector<std::array<std::size_t, 2>> edges;
  for (const auto& polygon : soup.polygons)
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const auto from = polygon[k], to = polygon[(k + 1) % polygon.size()];
      edges.push_back({std::min(from, to), std::max(from, to)});
    }
  std::sort(edges.begin(), edges.end());
  std::size_t open = 0, shared = 0;
  std::array<std::size_t, 2> open_edge{}, shared_edge{};
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last] == edges[first]) ++last;
    if (last - first == 1 && open++ == 0) open_edge = edges[first];
    if (last - first > 2 && shared++ == 0) shared_edge = edges[first];
  }
  const auto fault = [&](const char* format, std::size_t count, const std::array<std::size_t, 2>& edge) {
    return mesh_fault(
        path, fmt::format(fmt::runtime(format), count, shown(soup.points[edge[0]]), shown(soup.points[edge[1]])),
        "a closed surface without self-intersection");
  };
  if (shared > 0)
    throw fault("the surface is not manifold: {} edges belong to more than two faces, the first from {} to {}", shared,
                shared_edge);
  if (open > 0)
    throw fault("the surface is open: {} edges belong to one face only, the first from {} to {}", open, open_edge);
}

TriangleMesh to_mesh(Soup& soup, const std::string& path, std::vector<std::string>& repairs) {
  const auto points = soup.points.size();
  const auto before = soup.polygons;
  if (!pmp::orient_polygon_soup(soup.points, soup.polygons) || soup.points.size() != points)
    throw mesh_fault(path, "the surface is not manifold: parts of it touch in a point only, or it has one side only",
                     "a closed surface without self-intersection");
  std::size_t turned = 0;
  for (std::size_t k = 0; k < before.size(); ++k) turned += before[k] != soup.polygons[k];
  if (turned > 0) repairs.push_back(fmt::format("{} faces turned to agree with their neighbours", turned));
  TriangleMesh mesh;
  pmp::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  if (!CGAL::is_triangle_mesh(mesh)) {
    if (!pmp::triangulate_faces(mesh))
      throw mesh_fault(path, "a face with many corners cannot be triangulated",
                       "triangles, or flat faces with an area");
    repairs.push_back("faces with more than three corners triangulated");
  }
  return mesh;
}

void check_mesh(TriangleMesh& mesh, const std::string& path, std::vector<std::string>& repairs) {
  const auto faces = mesh.number_of_faces();
  if (!pmp::remove_degenerate_faces(mesh))
    throw mesh_fault(path, "faces without area cannot be removed safely", "a mesh without slivers");
  mesh.collect_garbage();
  if (mesh.number_of_faces() != faces)
    repairs.push_back(fmt::format("{} faces without area removed", faces - mesh.number_of_faces()));
  if (mesh.is_empty() || !CGAL::is_closed(mesh))
    throw mesh_fault(path, "the mesh encloses nothing", "a closed surface without self-intersection");
  std::vector<std::pair<TriangleMesh::Face_index, TriangleMesh::Face_index>> crossing;
  pmp::self_intersections(mesh, std::back_inserter(crossing));
  if (!crossing.empty()) {
    const auto corner = mesh.point(mesh.target(mesh.halfedge(crossing.front().first)));
    throw mesh_fault(path,
                     fmt::format("the surface intersects itself: {} pairs of faces, the first near {}", crossing.size(),
                                 shown(corner)),
                     "a closed surface without self-intersection");
  }
  if (!pmp::does_bound_a_volume(mesh)) {
    pmp::orient_to_bound_a_volume(mesh);
    repairs.push_back("faces that looked inward turned outward");
  } else if (!pmp::is_outward_oriented(mesh)) {
    pmp::reverse_face_orientations(mesh);
    repairs.push_back("the whole surface looked inward and was turned outward");
  }
}

}  // namespace

MeshFile read_mesh_file(const std::string& path, double metres) {
  auto mesh = std::make_shared<Surface::Mesh>();
  std::vector<std::string> repairs;
  guarded("the mesh " + path + " cannot be used", [&] {
    auto soup = read_soup(path, metres);
    repair_soup(soup, repairs);
    if (soup.polygons.empty()) throw mesh_fault(path, "all faces of the mesh are degenerate", "a closed surface");
    check_edges(soup, path);
    mesh->triangles = to_mesh(soup, path, repairs);
    check_mesh(mesh->triangles, path, repairs);
  });
  return {Surface(mesh), repairs};
}

}  // namespace tektite::preprocess
