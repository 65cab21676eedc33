// Broken surface meshes of every kind of file: a clear error that names the file, or a mesh that can be used.
#include <fmt/format.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <random>
#include <sstream>

#include "robustness/small_run.hpp"

namespace {

namespace fs = std::filesystem;
using namespace tektite::test;
using Catch::Matchers::Contains;

using Corner = std::array<double, 3>;
using Face = std::array<int, 3>;

struct Mesh {
  std::vector<Corner> corners;
  std::vector<Face> faces;
};

/// A cube of 10 units.
Mesh cube() {
  std::ifstream file(std::string(WRONG_SCENES) + "/cube.off");
  std::string word;
  std::size_t corners = 0, faces = 0, edges = 0;
  file >> word >> corners >> faces >> edges;
  Mesh mesh{std::vector<Corner>(corners), std::vector<Face>(faces)};
  for (auto& corner : mesh.corners) file >> corner[0] >> corner[1] >> corner[2];
  for (auto& face : mesh.faces) file >> edges >> face[0] >> face[1] >> face[2];
  if (!file) throw std::runtime_error("cube.off is not what it was");
  return mesh;
}

std::string off(const Mesh& mesh) {
  auto text = fmt::format("OFF\n{} {} 0\n", mesh.corners.size(), mesh.faces.size());
  for (const auto& corner : mesh.corners) text += fmt::format("{}\n", fmt::join(corner, " "));
  for (const auto& face : mesh.faces) text += fmt::format("3 {}\n", fmt::join(face, " "));
  return text;
}

std::string obj(const Mesh& mesh) {
  std::string text;
  for (const auto& corner : mesh.corners) text += fmt::format("v {}\n", fmt::join(corner, " "));
  for (const auto& face : mesh.faces) text += fmt::format("f {} {} {}\n", face[0] + 1, face[1] + 1, face[2] + 1);
  return text;
}

std::string ply(const Mesh& mesh) {
  auto text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\nelement face "
      "{}\nproperty list uchar int vertex_indices\nend_header\n",
      mesh.corners.size(), mesh.faces.size());
  for (const auto& corner : mesh.corners) text += fmt::format("{}\n", fmt::join(corner, " "));
  for (const auto& face : mesh.faces) text += fmt::format("3 {}\n", fmt::join(face, " "));
  return text;
}

std::string ascii_stl(const Mesh& mesh) {
  std::string text = "solid cube\n";
  for (const auto& face : mesh.faces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int corner : face)
      text += fmt::format("vertex {}\n", fmt::join(mesh.corners[static_cast<std::size_t>(corner)], " "));
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid cube\n";
}

std::string binary_stl(const Mesh& mesh) {
  std::string bytes(80, ' ');
  const auto append = [&](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  append(static_cast<std::uint32_t>(mesh.faces.size()));
  for (const auto& face : mesh.faces) {
    append(std::array<float, 3>{});
    for (const int corner : face)
      for (const double x : mesh.corners[static_cast<std::size_t>(corner)]) append(static_cast<float>(x));
    append(std::uint16_t{0});
  }
  return bytes;
}

struct Kind {
  std::string file;
  std::string (*write)(const Mesh&);
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"cube.off", off}, {"cube.obj", obj}, {"cube.ply", ply}, {"ascii.stl", ascii_stl}, {"binary.stl", binary_stl}};
  return all;
}

/// A scene with one mesh, in a folder of its own.
class Place {
 public:
  Place() { fs::copy(std::string(WRONG_SCENES) + "/solid.toml", folder_.path()); }
  Outcome check(const std::string& file, const std::string& bytes) const {
    std::ofstream(folder_.file(file), std::ios::binary) << bytes;
    const auto outcome = run_in(folder_.path(),
                                {stage_program("preprocess"), "--check", "solid.toml", "--threads", "1", "--set",
                                 "body.block.shape.file=\"" + file + "\""},
                                limit_resources);
    INFO(file << ": exit code " << outcome.code << "\n" << outcome.faults);
    CHECK((outcome.code == 0 || outcome.code == 2));
    if (outcome.code == 2) {
      CHECK_THAT(outcome.faults, Contains("body.block.shape"));
      CHECK(std::count(outcome.faults.begin(), outcome.faults.end(), '\n') == 1);
    }
    return outcome;
  }

 private:
  TemporaryFolder folder_;
};

TEST_CASE("Meshes: the cube from which they are made is right in every kind of file") {
  const Place place;
  for (const auto& kind : kinds()) {
    INFO(kind.file);
    const auto outcome = place.check(kind.file, kind.write(cube()));
    CHECK(outcome.code == 0);
    CHECK_THAT(outcome.output, Contains("125 particles"));
  }
}

TEST_CASE("Meshes: what cannot be a body is refused in every kind of file") {
  const Place place;
  for (const auto& kind : kinds()) {
    INFO(kind.file);
    const auto refuse = [&](const Mesh& mesh, const std::string& what) {
      INFO(what);
      CHECK(place.check(kind.file, kind.write(mesh)).code == 2);
    };
    auto open = cube();
    open.faces.pop_back();
    refuse(open, "open");
    auto crossing = cube();
    crossing.corners[6] = {-5.0, -5.0, 5.0};
    refuse(crossing, "crosses itself");
    for (const double value : {std::nan(""), std::numeric_limits<double>::infinity(), 1e300}) {
      auto wild = cube();
      wild.corners[2][1] = value;
      refuse(wild, "a corner at " + std::to_string(value));
    }
    refuse({cube().corners, {}}, "without faces");
    refuse({{}, {}}, "empty");
    auto flat = cube();
    for (auto& corner : flat.corners) corner[2] = 0.0;
    refuse(flat, "flat");
    CHECK(place.check(kind.file, "").code == 2);
    CHECK(place.check(kind.file, "What is written here is no mesh, but text.\n").code == 2);
    CHECK(place.check(kind.file, std::string(1000, '\0')).code == 2);
  }
}

TEST_CASE("Meshes: a face of a corner that is not there, and counts that are not true, are refused") {
  const Place place;
  auto beyond = cube();
  beyond.faces[3][1] = 800;
  for (const auto& kind : kinds())
    if (kind.file.find("stl") == std::string::npos) CHECK(place.check(kind.file, kind.write(beyond)).code == 2);
  CHECK(place.check("cube.off", "OFF\n4000000000 12 0\n0 0 0\n").code == 2);
  CHECK(place.check("cube.off", "OFF\n-8 -12 0\n0 0 0\n").code == 2);
  CHECK(place.check("cube.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n").code == 2);
  CHECK(place.check("cube.obj", "v 0 0 0\nf 1 2 -7\n").code == 2);
  auto counted = binary_stl(cube());
  for (const std::uint32_t faces : {0u, 5u, 0xFFFFFFFFu}) {
    std::memcpy(counted.data() + 80, &faces, sizeof faces);
    CHECK(place.check("binary.stl", counted).code == 2);
  }
}

void spoil(int times, unsigned seed) {
  INFO("TEKTITE_SEED=" << seed);
  std::mt19937 random(seed);
  const Place place;
  int used = 0, all = 0;
  for (const auto& kind : kinds()) {
    const auto whole = kind.write(cube());
    for (int k = 0; k < times; ++k) {
      used += place.check(kind.file, whole.substr(0, random() % whole.size())).code == 0;
      auto bytes = whole;
      for (int flips = 1 + k % 3; flips > 0; --flips) {
        auto& byte = bytes[random() % bytes.size()];
        byte = static_cast<char>(byte ^ (1 << random() % 8));
      }
      used += place.check(kind.file, bytes).code == 0;
      all += 2;
    }
  }
  std::cout << "meshes, seed " << seed << ": " << used << " of " << all << " could be used\n";
}

TEST_CASE("Meshes: cut or with bits flipped, they are refused or can be used") { spoil(3, seed()); }

TEST_CASE("Meshes: the same, a thousand times", "[.long]") { spoil(100, seed()); }

}  // namespace
