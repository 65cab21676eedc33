#pragma once
// Which rank has which particle: recursive coordinate bisection (Berger and Bokhari 1987) by Zoltan. A box of particles
// is cut across its longest side into two of equal cost, and these again; no rank knows the places of all.

#include <array>
#include <span>
#include <vector>

namespace tektite {

/// What a partition sees of a particle.
struct PartitionPoint {
  std::array<double, 3> x{};  ///< m; of fewer dimensions the rest is zero
  double cost = 1.0;
};

/// The rank that gets each of the points that this rank has. Particles in one place go to one rank, and a rank may get
/// none.
std::vector<int> ranks_of(std::span<const PartitionPoint> points);

}  // namespace tektite
