#pragma once
// Points near a place, found by cells: what lies within one cell size of it is in the cells around it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "postprocess/whole.hpp"

namespace tektite {

/// Points sorted by the cell in which they lie. The key keeps 21 bits of each cell coordinate: cells that are two
/// million cells apart share a key, which costs a few more distances and changes no result.
class PointGrid {
 public:
  PointGrid(const std::vector<Point>& points, double cell_size) : cell_size_(cell_size), entries_(points.size()) {
    for (std::size_t i = 0; i < points.size(); ++i)
      entries_[i] = {key(cell_of(points[i])), static_cast<std::uint32_t>(i)};
    std::sort(entries_.begin(), entries_.end());
    for (std::size_t k = 0; k < entries_.size(); ++k)
      if (k == 0 || entries_[k].first != entries_[k - 1].first) begin_[entries_[k].first] = k;
  }

  /// Calls visit(j) for every point j in the cells around `point`.
  template <class Visit>
  void around(const Point& point, int dimensions, const Visit& visit) const {
    const auto centre = cell_of(point);
    const std::int64_t reach_y = dimensions > 1 ? 1 : 0;
    const std::int64_t reach_z = dimensions > 2 ? 1 : 0;
    for (std::int64_t z = -reach_z; z <= reach_z; ++z)
      for (std::int64_t y = -reach_y; y <= reach_y; ++y)
        for (std::int64_t x = -1; x <= 1; ++x) {
          const auto wanted = key({centre[0] + x, centre[1] + y, centre[2] + z});
          const auto found = begin_.find(wanted);
          if (found == begin_.end()) continue;
          for (auto k = found->second; k < entries_.size() && entries_[k].first == wanted; ++k)
            visit(entries_[k].second);
        }
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  Cell cell_of(const Point& point) const {
    Cell cell;
    for (int k = 0; k < 3; ++k)
      cell[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(std::floor(point[k] / cell_size_));
    return cell;
  }
  static std::uint64_t key(const Cell& cell) {
    constexpr std::uint64_t bits = (std::uint64_t{1} << 21) - 1;
    std::uint64_t packed = 0;
    for (const auto coordinate : cell) packed = packed << 21 | (static_cast<std::uint64_t>(coordinate) & bits);
    return packed;
  }

  double cell_size_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> entries_;
  std::unordered_map<std::uint64_t, std::size_t> begin_;
};

}  // namespace tektite
