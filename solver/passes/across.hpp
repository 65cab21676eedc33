#pragma once

#include <cstddef>

namespace tektite {

/// Rate of deformation across the plane: solved for in plane stress, zero in every other space.
template <bool plane_stress>
double across(const double* across_rate, std::size_t i) {
  if constexpr (plane_stress)
    return across_rate[i];
  else
    return 0.0;
}

}  // namespace tektite
