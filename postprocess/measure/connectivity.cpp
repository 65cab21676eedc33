#include "postprocess/measure/connectivity.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

#include "postprocess/measure/point_grid.hpp"

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

/// A particle and its image in the axis are one ring, seen on both sides.
void join_rings(UnionFind& sets, const Whole& whole) {
  if (whole.axis_image == 0) return;
  const auto computed = static_cast<std::uint32_t>(std::ranges::count(whole.image, 0));
  for (std::uint32_t i = 0; i < whole.count(); ++i)
    if ((whole.image[i] & whole.axis_image) != 0) sets.join(i, i - computed * whole.axis_image);
}

UnionFind link_neighbours(const Whole& whole, double link) {
  const auto& h = whole.smoothing_length;
  const PointGrid grid(whole.position, link * *std::max_element(h.begin(), h.end()));
  UnionFind sets(whole.count());
  join_rings(sets, whole);
  grid.for_each_pair(whole.dimensions, [&](std::uint32_t i, std::uint32_t j) {
    if (whole.body[i] != whole.body[j] || whole.severed[i] != 0 || whole.severed[j] != 0) return;
    const double reach = 0.5 * link * (h[i] + h[j]);
    const auto apart = whole.position[i] - whole.position[j];
    if (dot(apart, apart) < reach * reach) sets.join(i, j);
  });
  return sets;
}

void add_particle(Fragment& fragment, const Whole& whole, std::size_t i) {
  const double mass = whole.axis_image == 0 ? whole.mass[i] : 0.5 * whole.mass[i];  // half of a ring on either side
  fragment.body = whole.body[i];
  fragment.count += (whole.image[i] & whole.axis_image) == 0 ? 1 : 0;
  fragment.mass += mass;
  fragment.centre += mass * whole.position[i];
  fragment.velocity += mass * whole.velocity[i];
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
