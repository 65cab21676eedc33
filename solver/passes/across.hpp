#pragma once

#include <cstddef>

#include "passes/side_by_side.hpp"

namespace tektite {

/// Rate of deformation across the plane: solved for in plane stress, zero in every other space.
template <bool plane_stress>
double across(const double* across_rate, std::size_t i) {
  if constexpr (plane_stress)
    return across_rate[i];
  else
    return 0.0;
}
template <bool plane_stress>
WidePack across(const double* across_rate, const SideBySide& i) {
  if constexpr (plane_stress)
    return read(across_rate, i);
  else
    return 0.0;
}

/// Factor of the density over a step in which the volume grows by the rate x/dt: e^-x by its Padé approximant, which is
/// of the leapfrog's order, positive as long as |x| < 2, and half the cost.
inline double density_factor(double x) { return (2.0 - x) / (2.0 + x); }

}  // namespace tektite
