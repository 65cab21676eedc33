#include "advice/thickness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace tektite {
namespace {

/// Of a spacing: a wider gap ends a row.
constexpr double gap = 1.5;

/// A particle with the row in which it lies, by the other coordinates in spacings.
struct InRow {
  std::array<std::int64_t, 2> row{};
  double along = 0.0;  ///< spacings
  std::size_t index = 0;
};

std::vector<InRow> rows_along(const Particles& particles, const Body& body, std::size_t axis) {
  const auto width = static_cast<std::size_t>(particles.dimensions());
  const auto position = particles.reals(Field::position);
  const auto place = [&](std::size_t i, std::size_t k) {
    return (position[i * width + k] - position[body.range.begin * width + k]) / body.spacing;
  };
  std::vector<InRow> all;
  for (std::size_t i = body.range.begin; i < body.range.end; ++i) {
    InRow entry{{}, place(i, axis), i};
    for (std::size_t k = 0, n = 0; k < width; ++k)
      if (k != axis) entry.row[n++] = std::llround(place(i, k));
    all.push_back(entry);
  }
  std::ranges::sort(all,
                    [](const InRow& a, const InRow& b) { return a.row != b.row ? a.row < b.row : a.along < b.along; });
  return all;
}

}  // namespace

double particles_through(const Particles& particles, const Body& body, const std::vector<SymmetryPlane>& symmetry) {
  const auto width = static_cast<std::size_t>(particles.dimensions());
  const auto position = particles.reals(Field::position);
  std::vector<double> shortest(body.range.size(), std::numeric_limits<double>::infinity());
  for (std::size_t axis = 0; axis < width; ++axis) {
    const auto all = rows_along(particles, body, axis);
    const auto plane = std::ranges::find(symmetry, static_cast<int>(axis), &SymmetryPlane::axis);
    const auto beside_plane = [&](const InRow& entry) {
      return plane != symmetry.end() &&
             std::abs(position[entry.index * width + axis] - plane->at) < 0.5 * gap * body.spacing;
    };
    for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
      for (end = first + 1;
           end < all.size() && all[end].row == all[first].row && all[end].along - all[end - 1].along <= gap;)
        ++end;
      double length = all[end - 1].along - all[first].along + 1.0;
      if (beside_plane(all[first]) || beside_plane(all[end - 1])) length *= 2.0;
      for (std::size_t k = first; k < end; ++k) {
        auto& least = shortest[all[k].index - body.range.begin];
        least = std::min(least, length);
      }
    }
  }
  const auto middle = shortest.begin() + static_cast<std::ptrdiff_t>(shortest.size() / 2);
  std::nth_element(shortest.begin(), middle, shortest.end());
  return *middle;
}

}  // namespace tektite
