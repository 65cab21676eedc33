#include "postprocess/measure/connectivity.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

namespace tektite {
namespace {

class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    i = root(i);
    j = root(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Particles sorted by the cell in which they lie. The key keeps 21 bits of each cell coordinate: cells that are two
/// million cells apart share a key, which costs a few more distances and changes no result.
class CellGrid {
 public:
  CellGrid(const std::vector<Point>& points, double cell_size) : cell_size_(cell_size), entries_(points.size()) {
    for (std::size_t i = 0; i < points.size(); ++i)
      entries_[i] = {key(cell_of(points[i])), static_cast<std::uint32_t>(i)};
    std::sort(entries_.begin(), entries_.end());
    for (std::size_t k = 0; k < entries_.size(); ++k)
      if (k == 0 || entries_[k].first != entries_[k - 1].first) begin_[entries_[k].first] = k;
  }

  /// Calls visit(j) for every particle in the cells around `point`.
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

UnionFind link_neighbours(const Whole& whole, double link) {
  const auto& h = whole.smoothing_length;
  const CellGrid grid(whole.position, link * *std::max_element(h.begin(), h.end()));
  UnionFind sets(whole.count());
  for (std::uint32_t i = 0; i < whole.count(); ++i)
    grid.around(whole.position[i], whole.dimensions, [&](std::uint32_t j) {
      if (j >= i || whole.body[i] != whole.body[j]) return;
      const double reach = 0.5 * link * (h[i] + h[j]);
      const auto apart = whole.position[i] - whole.position[j];
      if (dot(apart, apart) < reach * reach) sets.join(i, j);
    });
  return sets;
}

void add_particle(Fragment& fragment, const Whole& whole, std::size_t i) {
  fragment.body = whole.body[i];
  fragment.count += 1;
  fragment.mass += whole.mass[i];
  fragment.centre += whole.mass[i] * whole.position[i];
  fragment.velocity += whole.mass[i] * whole.velocity[i];
}

}  // namespace

std::uint32_t Fragments::heaviest(std::int32_t body) const {
  for (std::size_t k = 0; k < list.size(); ++k)
    if (list[k].body == body) return static_cast<std::uint32_t>(k);
  throw std::logic_error("a body has no particles");
}

Fragments find_fragments(const Whole& whole, double link) {
  auto sets = link_neighbours(whole, link);
  std::unordered_map<std::uint32_t, std::uint32_t> number_of_root;
  std::vector<Fragment> found;
  std::vector<std::uint32_t> number(whole.count());
  for (std::uint32_t i = 0; i < whole.count(); ++i) {
    const auto [entry, fresh] = number_of_root.try_emplace(sets.root(i), static_cast<std::uint32_t>(found.size()));
    if (fresh) found.emplace_back();
    number[i] = entry->second;
    add_particle(found[entry->second], whole, i);
  }
  for (auto& fragment : found) {
    fragment.centre = (1.0 / fragment.mass) * fragment.centre;
    fragment.velocity = (1.0 / fragment.mass) * fragment.velocity;
  }

  std::vector<std::uint32_t> order(found.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
    return found[a].body != found[b].body ? found[a].body < found[b].body : found[a].mass > found[b].mass;
  });
  Fragments fragments;
  std::vector<std::uint32_t> place(found.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    place[order[k]] = k;
    fragments.list.push_back(found[order[k]]);
  }
  for (const auto k : number) fragments.label.push_back(place[k]);
  return fragments;
}

}  // namespace tektite
