#pragma once
// How much a run turns. Pressure between two particles acts along the line between them and keeps it; shear stress and
// viscosity keep it only where their gradients are exact for a rotation.

#include <vector>

#include "core/particles.hpp"
#include "parallel/sums.hpp"

namespace tektite {

/// Axes about which something can turn: all three in the space solid, z in the plane, none in the others.
std::vector<int> axes_of_turning(Space space);

/// Mass, first moments of mass and momentum, and angular momentum, which are summed together.
inline constexpr std::size_t count_of_moments(int dimensions) {
  return static_cast<std::size_t>(1 + 2 * dimensions + (dimensions == 3 ? 3 : 1));
}

/// Is asked again and again for how much a run turns.
class AngularMomentum {
 public:
  /// About the centre of mass and each of the axes_of_turning(), kg m²/s (per metre of thickness in the plane).
  std::vector<double> operator()(const Particles& particles);

 private:
  RepeatedSum<count_of_moments(2)> in_plane_;
  RepeatedSum<count_of_moments(3)> in_space_;
};

/// What it would be if all turned one way: Σ m |x - X| |v - V|, with centre of mass X and mean velocity V.
double largest_angular_momentum_of(const Particles& particles);

}  // namespace tektite
