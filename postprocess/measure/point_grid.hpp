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

  /// Calls visit(i, j) once for every two points that lie in one cell or in two that touch.
  template <class Visit>
  void for_each_pair(int dimensions, const Visit& visit) const {
    for (std::size_t first = 0, end = 0; first < entries_.size(); first = end) {
      end = end_of_cell(first);
      for (auto a = first; a < end; ++a)
        for (auto b = a + 1; b < end; ++b) visit(entries_[a].second, entries_[b].second);
      for_each_cell_ahead(entries_[first].first, dimensions, [&](std::size_t begin) {
        const auto other_end = end_of_cell(begin);
        for (auto a = first; a < end; ++a)
          for (auto b = begin; b < other_end; ++b) visit(entries_[a].second, entries_[b].second);
      });
    }
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  static constexpr int bits = 21;

  std::size_t end_of_cell(std::size_t first) const {
    auto end = first;
    while (end < entries_.size() && entries_[end].first == entries_[first].first) ++end;
    return end;
  }

  /// Calls work with the first entry of each cell that touches this one and comes behind it in the order of x, y, z:
  /// so of two such cells one is ahead of the other.
  template <class Work>
  void for_each_cell_ahead(std::uint64_t cell, int dimensions, const Work& work) const {
    const auto x = static_cast<std::int64_t>(cell >> 2 * bits), y = static_cast<std::int64_t>(cell >> bits),
               z = static_cast<std::int64_t>(cell);
    const std::int64_t reach_y = dimensions > 1 ? 1 : 0;
    const std::int64_t reach_z = dimensions > 2 ? 1 : 0;
    for (std::int64_t i = 0; i <= 1; ++i)
      for (std::int64_t j = i == 0 ? 0 : -reach_y; j <= reach_y; ++j)
        for (std::int64_t k = i == 0 && j == 0 ? 1 : -reach_z; k <= reach_z; ++k)
          if (const auto found = begin_.find(key({x + i, y + j, z + k})); found != begin_.end()) work(found->second);
  }

  Cell cell_of(const Point& point) const {
    Cell cell;
    for (int k = 0; k < 3; ++k)
      cell[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(std::floor(point[k] / cell_size_));
    return cell;
  }
  static std::uint64_t key(const Cell& cell) {
    constexpr std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
    std::uint64_t packed = 0;
    for (const auto coordinate : cell) packed = packed << bits | (static_cast<std::uint64_t>(coordinate) & mask);
    return packed;
  }

  double cell_size_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> entries_;
  std::unordered_map<std::uint64_t, std::size_t> begin_;
};

}  // namespace tektite
