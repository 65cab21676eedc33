#include "postprocess/render/framing.hpp"

#include <algorithm>
#include <cmath>

namespace tektite {
namespace {

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Point unit(const Point& a) { return (1.0 / norm(a)) * a; }

struct Looking {
  Point from;  ///< unit vector towards the camera
  Point up;
};

Looking look(int dimensions, const Picture& picture, const std::optional<SymmetryPlane>& cut) {
  if (dimensions < 3) return {{0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}};
  auto from = Point{0.35, 0.35, 0.35};
  from[cut ? cut->axis : 2] = cut ? -cut->side : 1.0;
  if (picture.from) from = *picture.from;
  const bool from_above = std::abs(from[1]) > std::max(std::abs(from[0]), std::abs(from[2]));
  return {unit(from), from_above ? Point{0.0, 0.0, 1.0} : Point{0.0, 1.0, 0.0}};
}

}  // namespace

Box framed(const Picture& picture, const Whole& whole, const std::vector<bool>& drawn,
           const std::vector<Segment>& segments) {
  Box box;
  if (picture.view) {
    auto low = Point::zero();
    auto high = Point::zero();
    for (std::size_t k = 0; k < picture.view->lower.size(); ++k) {
      low[static_cast<int>(k)] = picture.view->lower[k];
      high[static_cast<int>(k)] = picture.view->upper[k];
    }
    box.include(low);
    box.include(high);
    return box;
  }
  const auto fragments = find_fragments(whole, link_of_support);
  std::vector<double> body_mass(whole.bodies.size(), 0.0);
  for (const auto& fragment : fragments.list) body_mass[static_cast<std::size_t>(fragment.body)] += fragment.mass;
  for (std::size_t i = 0; i < whole.count(); ++i) {
    const auto& fragment = fragments.list[fragments.label[i]];
    if (!drawn[i] || fragment.mass < 0.01 * body_mass[static_cast<std::size_t>(fragment.body)]) continue;
    const double half = 0.5 * whole.bodies[static_cast<std::size_t>(whole.body[i])].spacing;
    box.include(whole.position[i] + Point{half, whole.dimensions > 1 ? half : 0.0, whole.dimensions > 2 ? half : 0.0});
    box.include(whole.position[i] - Point{half, whole.dimensions > 1 ? half : 0.0, whole.dimensions > 2 ? half : 0.0});
  }
  for (const auto& segment : segments) {
    box.include(segment.from);
    box.include(segment.to);
  }
  return box;
}

std::optional<SymmetryPlane> cut_of(const Picture& picture, const Scene& scene) {
  if (dimensions_of(scene.space) < 3 || picture.cut == "none") return std::nullopt;
  SymmetryPlane cut;
  if (picture.cut == "automatic") {
    if (scene.symmetry.empty()) return std::nullopt;
    cut = scene.symmetry.front();
  } else {
    cut = {picture.cut.front() - 'x', picture.cut_at, -1.0};
  }
  if (picture.from && (*picture.from)[cut.axis] != 0.0) cut.side = (*picture.from)[cut.axis] > 0.0 ? -1.0 : 1.0;
  return cut;
}

Camera aimed_camera(const Frame& frame, const Box& box, int dimensions, const Picture& picture,
                    const std::optional<SymmetryPlane>& cut) {
  const auto looking = look(dimensions, picture, cut);
  Camera camera;
  camera.from = looking.from;
  camera.right = unit(cross(looking.up, looking.from));
  camera.up = cross(looking.from, camera.right);
  camera.centre = box.centre();
  camera.middle = {frame.left + 0.5 * frame.width(), frame.lower + 0.5 * frame.height()};
  double half_width = 0.0;
  double half_height = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    Point point;
    for (int k = 0; k < 3; ++k) point[k] = (corner >> k & 1) != 0 ? box.high[k] : box.low[k];
    const auto apart = point - camera.centre;
    half_width = std::max(half_width, std::abs(dot(apart, camera.right)));
    half_height = std::max(half_height, std::abs(dot(apart, camera.up)));
  }
  constexpr double margin = 1.04;
  camera.scale = 0.5 / margin * std::min(frame.width() / half_width, frame.height() / half_height);
  return camera;
}

}  // namespace tektite
