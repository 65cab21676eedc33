// mesh: a closed surface from `file` (STL, OFF, OBJ, PLY; a relative path is relative to the scene), its coordinates
// taken in `unit` and multiplied by `scale`.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>

#include "preprocess/geometry/mesh_file.hpp"
#include "preprocess/geometry/mesh_rows.hpp"
#include "preprocess/geometry/shapes.hpp"
#include "preprocess/geometry/surface_mesh.hpp"

namespace tektite::preprocess {
namespace {

Surface moved(const Surface& surface, const Placement& placement) {
  if (placement.is_identity()) return surface;
  auto mesh = std::make_shared<Surface::Mesh>(surface.mesh());
  for (const auto vertex : mesh->triangles.vertices()) {
    auto& corner = mesh->triangles.point(vertex);
    const auto p = placement.apply({corner.x(), corner.y(), corner.z()});
    corner = MeshKernel::Point_3(p[0], p[1], p[2]);
  }
  return Surface(mesh);
}

class MeshShape final : public Shape {
 public:
  explicit MeshShape(MeshFile file) : file_(std::move(file)), rows_(std::make_unique<MeshRows>(file_.surface)) {}

  int dimensions() const override { return 3; }

  bool inside(const Point& x, double tolerance) const override {
    std::uint8_t mark = 0;
    rows_->mark({x, {{1.0, 0.0, 0.0}}, 1}, tolerance, {&mark, 1});
    return mark != 0;
  }

  void mark(const Row& row, double tolerance, std::span<std::uint8_t> marks) const override {
    const bool along_x = row.step[0] > 0.0 && row.step[1] == 0.0 && row.step[2] == 0.0;
    if (along_x)
      rows_->mark(row, tolerance, marks);
    else
      Shape::mark(row, tolerance, marks);
  }

  double reach(const Point& n) const override {
    double most = -std::numeric_limits<double>::infinity();
    const auto& mesh = file_.surface.mesh().triangles;
    for (const auto vertex : mesh.vertices()) {
      const auto& p = mesh.point(vertex);
      most = std::max(most, n[0] * p.x() + n[1] * p.y() + n[2] * p.z());
    }
    return most;
  }

  double measure() const override { return file_.surface.volume(); }
  Surface surface(const Placement& placement) const override { return moved(file_.surface, placement); }
  std::vector<std::string> remarks() const override { return file_.repairs; }

  /// The triangles themselves are moved, so that rows along x stay rows along x.
  bool move(const Placement& placement) override {
    file_.surface = moved(file_.surface, placement);
    rows_ = std::make_unique<MeshRows>(file_.surface);
    return true;
  }

 private:
  MeshFile file_;
  std::unique_ptr<MeshRows> rows_;
};

double read_metres(Section& section) {
  const auto unit = section.text("unit", "m");
  const auto quantity = parse_quantity("1 " + unit);
  if (!quantity || quantity->dimension != dimension::length)
    throw section.fault("unit", "not a unit of length", "m, cm, mm, um, in");
  return quantity->value * section.quantity("scale", dimension::none, limits::positive, 1.0);
}

}  // namespace

ShapePointer read_mesh(Section& section, int) {
  const std::filesystem::path given = section.text("file");
  const double metres = read_metres(section);
  const auto path = (std::filesystem::path(section.origin()).parent_path() / given).lexically_normal();
  std::optional<InputError> failure;
  try {
    auto file = read_mesh_file(path.string(), metres);
    for (auto& repair : file.repairs) repair = fmt::format("{}: {}", given.string(), repair);
    return std::make_unique<MeshShape>(std::move(file));
  } catch (const InputError& fault) {
    failure = section.fault("file", fault.what());
  }
  throw *failure;
}

}  // namespace tektite::preprocess
