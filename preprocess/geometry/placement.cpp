#include "preprocess/geometry/placement.hpp"

#include <cmath>

namespace tektite::preprocess {
namespace {

Point to_point(const std::vector<double>& values) {
  Point point{};
  for (std::size_t k = 0; k < values.size(); ++k) point[static_cast<int>(k)] = values[k];
  return point;
}

}  // namespace

Placement Placement::rotation(double angle, const Point& axis, const Point& about) {
  const double c = std::cos(angle), s = std::sin(angle);
  Placement placement;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    placement.rows_[i][i] = c + (1.0 - c) * axis[i] * axis[i];
    placement.rows_[i][j] = (1.0 - c) * axis[i] * axis[j] - s * axis[k];
    placement.rows_[i][k] = (1.0 - c) * axis[i] * axis[k] + s * axis[j];
  }
  placement.shift_ = about - placement.turn(about);
  return placement;
}

Placement Placement::translation(const Point& by) {
  Placement placement;
  placement.shift_ = by;
  return placement;
}

Point Placement::turn(const Point& direction) const {
  return {dot(rows_[0], direction), dot(rows_[1], direction), dot(rows_[2], direction)};
}

Point Placement::turn_inverse(const Point& direction) const {
  return direction[0] * rows_[0] + direction[1] * rows_[1] + direction[2] * rows_[2];
}

Point Placement::apply(const Point& x) const { return turn(x) + shift_; }
Point Placement::apply_inverse(const Point& x) const { return turn_inverse(x - shift_); }

Placement Placement::after(const Placement& first) const {
  Placement both;
  for (int i = 0; i < 3; ++i)
    both.rows_[i] = rows_[i][0] * first.rows_[0] + rows_[i][1] * first.rows_[1] + rows_[i][2] * first.rows_[2];
  both.shift_ = apply(first.shift_);
  return both;
}

bool Placement::is_identity() const {
  const Placement none;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (rows_[i][k] != none.rows_[i][k]) return false;
  return shift_[0] == 0.0 && shift_[1] == 0.0 && shift_[2] == 0.0;
}

Placement read_placement(Section& section, int dimensions) {
  Placement placement;
  if (section.has("rotate")) {
    if (dimensions == 1) throw section.fault("rotate", "a line has nothing to rotate about", "translate");
    auto rotate = section.section("rotate");
    const double angle = rotate.quantity("angle", dimension::none, limits::any);
    const Point z{{0, 0, 1}};
    const auto axis = dimensions == 3 ? read_direction(rotate, "axis", z) : z;
    const auto about = read_point(rotate, "about", dimensions, Point{});
    rotate.finish();
    placement = Placement::rotation(angle, axis, about);
  }
  if (section.has("translate"))
    placement = Placement::translation(read_point(section, "translate", dimensions)).after(placement);
  return placement;
}

Point read_point(Section& section, const std::string& key, int dimensions) {
  return to_point(section.quantities(key, dimension::length, static_cast<std::size_t>(dimensions)));
}

Point read_point(Section& section, const std::string& key, int dimensions, const Point& otherwise) {
  return section.has(key) ? read_point(section, key, dimensions) : otherwise;
}

Point read_direction(Section& section, const std::string& key, const Point& otherwise) {
  if (!section.has(key)) return otherwise;
  const auto direction = to_point(section.quantities(key, dimension::none, 3));
  const double length = norm(direction);
  if (length == 0.0) throw section.fault(key, "has no direction", "[x, y, z], not all zero");
  return (1.0 / length) * direction;
}

}  // namespace tektite::preprocess
