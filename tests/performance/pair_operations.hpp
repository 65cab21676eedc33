#pragma once
// Floating-point operations of a pair, counted from the formulas: additions, multiplications, divisions, roots, the
// larger of two. Comparisons and what is the same for all pairs are not counted; the viscous term is counted as if all
// neighbours came nearer. The kernel is the cubic spline, its gradient 8 operations without and 10 + D with the value.

#include "run/run_settings.hpp"

namespace tektite {

/// passes/eulerian_rates.hpp: differences 2 D, distance 2 D + 1, gradient 8, weight 1, v·x 2 D - 1, means 4, Π 14 and
/// 3, stress D (D + 1), force, damping and L D (4 D + 3), heat 2 and the signal 1.
constexpr int eulerian_operations(int d) { return 5 * d * d + 10 * d + 32; }

/// passes/lagrangian_sums.hpp on a lattice: F and its rate 4 D² + 4 D, forces 6 D² + 11 D + 26; with the mixed
/// correction 4 D + 1 and 5 D + 2 more.
constexpr int lagrangian_operations(int d, bool corrected) {
  return 10 * d * d + 15 * d + 26 + (corrected ? 9 * d + 3 : 0);
}

/// Zero where they are not counted.
inline int pair_operations(const RunSettings& settings) {
  const int d = dimensions_of(settings.scene.space);
  const auto& scheme = settings.scheme;
  const bool plain = hoops_of(settings.scene.space) == 0 && scheme.kernel == "cubic-spline" &&
                     !scheme.corrected_eulerian && !scheme.artificial_stress && scheme.hourglass_control == 0.0;
  if (plain && scheme.type == "total-lagrangian") return lagrangian_operations(d, scheme.corrected);
  if (plain && scheme.type == "eulerian") return eulerian_operations(d);
  return 0;
}

}  // namespace tektite
