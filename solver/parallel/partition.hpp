#pragma once
// Which rank has which particle: recursive coordinate bisection (Berger and Bokhari 1987). A box of particles is cut
// across its longest side into two of equal cost, and these again.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tektite {

/// What a partition sees of a particle.
struct PartitionPoint {
  std::array<double, 3> x{};  ///< m; of fewer dimensions the rest is zero
  std::int64_t id = 0;        ///< sets the order of those in one place
  double cost = 1.0;
};

/// The part of each point, from 0 on. Each part gets a point, as long as there are enough.
std::vector<int> bisect(std::span<const PartitionPoint> points, int parts);

}  // namespace tektite
