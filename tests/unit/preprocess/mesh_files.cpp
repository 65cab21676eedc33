#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "scene_text.hpp"
#include "support/fault.hpp"
#include "support/temporary_folder.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

using Corner = std::array<double, 3>;
using Face = std::array<int, 3>;

struct Triangles {
  std::vector<Corner> corners;
  std::vector<Face> faces;
};

/// A cube of this edge, from a corner; each side has two triangles that look outward.
Triangles cube(double edge = 1.0, const Corner& at = {0, 0, 0}) {
  Triangles mesh;
  for (int k = 0; k < 8; ++k)
    mesh.corners.push_back({at[0] + edge * (k & 1), at[1] + edge * (k >> 1 & 1), at[2] + edge * (k >> 2)});
  mesh.faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

Triangles together(Triangles a, const Triangles& b) {
  const int first = static_cast<int>(a.corners.size());
  a.corners.insert(a.corners.end(), b.corners.begin(), b.corners.end());
  for (const auto& f : b.faces) a.faces.push_back({first + f[0], first + f[1], first + f[2]});
  return a;
}

void write_off(const std::string& path, const Triangles& mesh) {
  std::ofstream file(path);
  file << "OFF\n" << mesh.corners.size() << ' ' << mesh.faces.size() << " 0\n";
  for (const auto& c : mesh.corners) file << c[0] << ' ' << c[1] << ' ' << c[2] << '\n';
  for (const auto& f : mesh.faces) file << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
}

void write_obj(const std::string& path, const Triangles& mesh) {
  std::ofstream file(path);
  for (const auto& c : mesh.corners) file << "v " << c[0] << ' ' << c[1] << ' ' << c[2] << '\n';
  for (const auto& f : mesh.faces) file << "f " << f[0] + 1 << ' ' << f[1] + 1 << ' ' << f[2] + 1 << '\n';
}

void write_ply(const std::string& path, const Triangles& mesh) {
  std::ofstream file(path);
  file << "ply\nformat ascii 1.0\nelement vertex " << mesh.corners.size()
       << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << mesh.faces.size()
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& c : mesh.corners) file << c[0] << ' ' << c[1] << ' ' << c[2] << '\n';
  for (const auto& f : mesh.faces) file << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
}

void write_ascii_stl(const std::string& path, const Triangles& mesh) {
  std::ofstream file(path);
  file << "solid cube\n";
  for (const auto& f : mesh.faces) {
    file << "facet normal 0 0 0\nouter loop\n";
    for (const int k : f)
      file << "vertex " << mesh.corners[k][0] << ' ' << mesh.corners[k][1] << ' ' << mesh.corners[k][2] << '\n';
    file << "endloop\nendfacet\n";
  }
  file << "endsolid cube\n";
}

void write_binary_stl(const std::string& path, const Triangles& mesh) {
  std::ofstream file(path, std::ios::binary);
  file << std::string(80, ' ');
  const auto put = [&](const auto& value) { file.write(reinterpret_cast<const char*>(&value), sizeof value); };
  put(static_cast<std::uint32_t>(mesh.faces.size()));
  for (const auto& f : mesh.faces) {
    for (int k = 0; k < 3; ++k) put(0.0f);
    for (const int corner : f)
      for (const double x : mesh.corners[corner]) put(static_cast<float>(x));
    put(std::uint16_t{0});
  }
}

struct MeshCase {
  TemporaryFolder folder;
  preprocess::ShapePointer shape(const std::string& file, const std::string& more = "") const {
    return shape_of("{ type = 'mesh', file = '" + folder.file(file) + "'" + more + " }", 3);
  }
  std::string fault(const std::string& file, const std::string& more = "") const {
    return fault_of([&] { shape(file, more); });
  }
};

bool said(const preprocess::Shape& shape, const std::string& words) {
  for (const auto& remark : shape.remarks())
    if (remark.find(words) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("Mesh: every kind of file gives the same cube, filled to the last particle") {
  const MeshCase test;
  write_off(test.folder.file("cube.off"), cube());
  write_obj(test.folder.file("cube.obj"), cube());
  write_ply(test.folder.file("cube.ply"), cube());
  write_ascii_stl(test.folder.file("ascii.stl"), cube());
  write_binary_stl(test.folder.file("binary.STL"), cube());
  const std::string name = GENERATE("cube.off", "cube.obj", "cube.ply", "ascii.stl", "binary.STL");
  INFO(name);
  const auto shape = test.shape(name, ", unit = 'mm', scale = 2");
  CHECK(shape->measure() == Approx(8e-9).epsilon(1e-12));
  CHECK(arrangement_of("{}", 3).arrangement->fill(*shape, 0.2e-3, {}).positions.size() == 1000);
  // With particles on every edge and corner, all of which belong to the closed set.
  CHECK(arrangement_of("{ convention = 'edges-included' }", 3).arrangement->fill(*shape, 0.2e-3, {}).positions.size() ==
        1331);
}

TEST_CASE("Mesh: rows through edges and corners and a motion give the same as the exact box") {
  const MeshCase test;
  write_off(test.folder.file("cube.off"), cube(2.0, {-1, -1, -1}));
  const std::string motion = ", rotate = { angle = '40 deg', axis = [1, 1, 0] }, translate = [0.1, 0, 0.2]";
  const auto mesh = test.shape("cube.off", motion);
  const auto box = shape_of("{ type = 'box', lower = [-1, -1, -1], upper = [1, 1, 1]" + motion + " }", 3);
  const auto arrangement = arrangement_of("{ convention = 'on-origin' }", 3);
  CHECK(arrangement.arrangement->count(*mesh, 0.05) == arrangement.arrangement->count(*box, 0.05));
  CHECK(mesh->inside({{0.1, 0, 0.2}}, 0.0));
  CHECK_FALSE(mesh->inside({{3, 0, 0.2}}, 0.0));
}

TEST_CASE("Mesh: a cavity stays empty") {
  const MeshCase test;
  auto cavity = cube(0.5, {0.25, 0.25, 0.25});
  write_off(test.folder.file("hollow.off"), together(cube(), cavity));
  const auto shape = test.shape("hollow.off");
  CHECK(shape->measure() == Approx(0.875).epsilon(1e-12));
  CHECK(said(*shape, "turned outward"));
  CHECK(arrangement_of("{}", 3).arrangement->count(*shape, 0.05) == 8000 - 1000);
}

TEST_CASE("Mesh: in booleans, its part is corefined exactly") {
  const MeshCase test;
  write_off(test.folder.file("cube.off"), cube());
  const auto shape =
      shape_of("{ type = 'difference', parts = [{ type = 'mesh', file = '" + test.folder.file("cube.off") +
                   "' }, { type = 'box', lower = [0.5, -1, -1], upper = [2, 2, 0.5] }] }",
               3);
  CHECK(shape->measure() == Approx(0.75).epsilon(1e-12));
}

TEST_CASE("Mesh: what can be repaired safely is repaired and said") {
  const MeshCase test;
  auto inward = cube();
  for (auto& face : inward.faces) std::swap(face[0], face[1]);
  write_off(test.folder.file("inward.off"), inward);
  CHECK(test.shape("inward.off")->measure() == Approx(1.0));
  CHECK(said(*test.shape("inward.off"), "looked inward"));

  auto one_turned = cube();
  std::swap(one_turned.faces[3][0], one_turned.faces[3][1]);
  write_off(test.folder.file("turned.off"), one_turned);
  CHECK(test.shape("turned.off")->measure() == Approx(1.0));
  CHECK(said(*test.shape("turned.off"), "turned to agree"));

  Triangles doubled;
  for (const auto& face : cube().faces) {
    const int first = static_cast<int>(doubled.corners.size());
    for (const int k : face) doubled.corners.push_back(cube().corners[k]);
    doubled.faces.push_back({first, first + 1, first + 2});
  }
  doubled.corners.push_back({5, 5, 5});
  doubled.faces.push_back({0, 0, 1});
  write_off(test.folder.file("doubled.off"), doubled);
  const auto shape = test.shape("doubled.off");
  CHECK(shape->measure() == Approx(1.0));
  CHECK(said(*shape, "doubled points stitched"));
  CHECK(said(*shape, "degenerate or doubled faces removed"));
  CHECK(said(*shape, "points without a face removed"));
}

TEST_CASE("Mesh: a surface that bounds no solid is refused, with the file and the key") {
  const MeshCase test;
  auto open = cube();
  open.faces.pop_back();
  write_off(test.folder.file("open.off"), open);
  CHECK_THAT(test.fault("open.off"), Catch::Contains("the surface is open: 3 edges") && Catch::Contains("open.off") &&
                                         Catch::Contains("shape.file"));
  write_off(test.folder.file("crossing.off"), together(cube(), cube(1.0, {0.5, 0.4, 0.3})));
  CHECK_THAT(test.fault("crossing.off"), Catch::Contains("intersects itself"));
  auto fin = cube();
  fin.corners.push_back({-1, -1, 0.5});
  fin.faces.push_back({0, 4, 8});
  write_off(test.folder.file("fin.off"), fin);
  CHECK_THAT(test.fault("fin.off"), Catch::Contains("not manifold: 1 edges belong to more than two faces"));
  auto by_a_corner = together(cube(), cube(1.0, {1, 1, 1}));
  write_off(test.folder.file("corner.off"), by_a_corner);
  CHECK_THAT(test.fault("corner.off"), Catch::Contains("not manifold"));
}

TEST_CASE("Mesh: faces without an area, with one side only or at infinity are refused with the reason") {
  const MeshCase test;
  const auto says = [&](const std::string& corners_and_faces) {
    std::ofstream(test.folder.file("odd.off")) << "OFF\n" << corners_and_faces;
    return test.fault("odd.off");
  };
  const std::string on_a_line = "0 0 0\n1 0 0\n2 0 0\n3 0 0\n", four = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  CHECK_THAT(says("4 4 0\n" + on_a_line + four), Catch::Contains("odd.off: the mesh encloses nothing"));
  CHECK_THAT(says("2 1 0\n0 0 0\n1 0 0\n3 0 1 0\n"),
             Catch::Contains("odd.off: all faces of the mesh are degenerate (allowed: a closed surface)"));
  CHECK_THAT(says("4 4 0\n1 0 0\n0 0 0\n2 0 0\n0 1 0\n3 0 1 2\n3 1 0 3\n3 1 3 2\n3 2 3 0\n"),  // one of four
             Catch::Contains("odd.off: faces without area cannot be removed safely"));
  CHECK_THAT(says("4 4 0\n0 0 0\n1 0 0\n0 1 0\n0.3 0.3 0\n" + four),  // flat
             Catch::Contains("odd.off: the surface intersects itself"));
  CHECK_THAT(says("8 6 0\n" + on_a_line + "4 0 0\n5 0 0\n6 0 0\n7 0 0\n" +
                  "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n"),
             Catch::Contains("odd.off: a face with many corners cannot be triangulated (allowed: triangles"));
  // Ten triangles over six points, each edge in two of them, make the projective plane.
  CHECK_THAT(says("6 10 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n2 1 0\n3 0 1 2\n3 0 2 3\n3 0 3 4\n3 0 4 5\n"
                  "3 0 5 1\n3 1 2 4\n3 2 3 5\n3 3 4 1\n3 4 5 2\n3 5 1 3\n"),
             Catch::Contains("odd.off: the surface is not manifold") && Catch::Contains("one side only"));
  auto far = cube();
  far.corners[3][0] = std::numeric_limits<double>::infinity();
  auto pointless = cube();
  pointless.faces[5][2] = 8;
  write_ply(test.folder.file("pointless.ply"), pointless);
  CHECK_THAT(test.fault("pointless.ply"), Catch::Contains("pointless.ply: a face names a point that is not there"));
  write_binary_stl(test.folder.file("far.stl"), far);
  CHECK_THAT(test.fault("far.stl"), Catch::Contains("far.stl: a coordinate is not a finite number"));
}

TEST_CASE("Mesh: files that are missing, empty, cut short or of another kind are refused") {
  const MeshCase test;
  CHECK_THAT(test.fault("nowhere.stl"), Catch::Contains("no such mesh file"));
  std::filesystem::create_directory(test.folder.file("folder.stl"));
  CHECK_THAT(test.fault("folder.stl"), Catch::Contains("folder.stl: this is no file"));
  std::ofstream(test.folder.file("empty.stl"));
  CHECK_THAT(test.fault("empty.stl"), Catch::Contains("empty"));
  std::ofstream(test.folder.file("body.step")) << "ISO-10303-21;";
  CHECK_THAT(test.fault("body.step"), Catch::Contains(".stl, .off, .obj, .ply"));
  std::ofstream(test.folder.file("words.off")) << "these are words\n";
  CHECK_THAT(test.fault("words.off"), Catch::Contains("words.off"));
  write_binary_stl(test.folder.file("short.stl"), cube());
  std::filesystem::resize_file(test.folder.file("short.stl"), 300);
  CHECK_THAT(test.fault("short.stl"), Catch::Contains("cut short"));
  std::ofstream(test.folder.file("loud.stl")) << "SOLID CUBE\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\n";
  CHECK_THAT(test.fault("loud.stl"), Catch::Contains("words in small letters"));
  write_off(test.folder.file("none.off"), {});
  CHECK_THAT(test.fault("none.off"), Catch::Contains("none.off"));
  write_off(test.folder.file("cube.off"), cube());
  CHECK_THAT(test.fault("cube.off", ", unit = 'kg'"), Catch::Contains("m, cm, mm, um, in"));
}

TEST_CASE("Mesh: one that is a thousand times too large or too small for its spacing is refused") {
  const MeshCase test;
  write_off(test.folder.file("cube.off"), cube());
  const auto body = [&](const std::string& unit) {
    return "[body.a]\nmaterial = 'unit'\nshape = { type = 'mesh', file = '" + test.folder.file("cube.off") +
           "', unit = '" + unit + "' }\n";
  };
  CHECK(result_of("solid", body("m")).snapshot.particles.count() == 1000);
  CHECK_THAT(fault_of([&] { result_of("solid", body("km")); }), Catch::Contains("is the unit right?"));
  CHECK_THAT(fault_of([&] { result_of("solid", body("mm")); }), Catch::Contains("is the unit right?"));
}
