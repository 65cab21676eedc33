#pragma once
// What hexagonal and close-packed share: rows along x through given points, cut to the bounding box.

#include <algorithm>
#include <optional>

#include "preprocess/arrangement/arrangements.hpp"
#include "preprocess/arrangement/rows.hpp"

namespace tektite::preprocess {

/// The multiples of `distance` from the origin that lie within the box along an axis: first, first + 1, ...
struct Count {
  Count(const Box& box, int axis, const Point& origin, double distance)
      : first(ceil_within((box.lower[axis] - origin[axis]) / distance)),
        size(static_cast<std::size_t>(
            std::max(floor_within((box.upper[axis] - origin[axis]) / distance) - first + 1, 0LL))) {}
  long long first;
  std::size_t size;
};

/// The row along x with this spacing that has a particle on `through`.
inline Row row_through(const Box& box, const Point& through, double spacing) {
  const Count along(box, 0, through, spacing);
  Row row{through, {{spacing, 0.0, 0.0}}, along.size};
  row.start[0] += static_cast<double>(along.first) * spacing;
  return row;
}

}  // namespace tektite::preprocess
