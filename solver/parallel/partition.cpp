#include "parallel/partition.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tektite {
namespace {

using Members = std::span<std::uint32_t>;

std::size_t longest_side(std::span<const PartitionPoint> points, Members members) {
  std::size_t longest = 0;
  double most = -1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [least, largest] = std::ranges::minmax(members, {}, [&](auto i) { return points[i].x[k]; });
    const double side = points[largest].x[k] - points[least].x[k];
    if (side > most) longest = k, most = side;
  }
  return longest;
}

/// How many of the sorted members the first `left` of all parts get: this share of the cost, and a point for each part.
std::size_t share_of(std::span<const PartitionPoint> points, Members members, int left, int parts) {
  const auto count = members.size(), first = static_cast<std::size_t>(left), all = static_cast<std::size_t>(parts);
  if (count < all) return count * first / all;
  double whole = 0.0;
  for (const auto i : members) whole += points[i].cost;
  const double wanted = whole * left / parts;
  std::size_t share = 0;
  for (double cost = 0.0; share < count; ++share) {
    const double half = 0.5 * points[members[share]].cost;
    if (cost + half > wanted) break;
    cost += 2.0 * half;
  }
  return std::clamp(share, first, count - (all - first));
}

void cut(std::span<const PartitionPoint> points, Members members, int first_part, int parts, std::vector<int>& part) {
  if (parts == 1 || members.empty()) {
    for (const auto i : members) part[i] = first_part;
    return;
  }
  const auto axis = longest_side(points, members);
  std::ranges::sort(members, {}, [&](auto i) { return std::pair(points[i].x[axis], points[i].id); });
  const int left = parts / 2;
  const auto share = share_of(points, members, left, parts);
  cut(points, members.first(share), first_part, left, part);
  cut(points, members.subspan(share), first_part + left, parts - left, part);
}

}  // namespace

std::vector<int> bisect(std::span<const PartitionPoint> points, int parts) {
  std::vector<std::uint32_t> members(points.size());
  std::iota(members.begin(), members.end(), 0U);
  std::vector<int> part(points.size(), 0);
  cut(points, members, 0, parts, part);
  return part;
}

}  // namespace tektite
