#pragma once

#include <cmath>

#include "core/tensor.hpp"
#include "physics/kernels/kernel.hpp"
#include "support/lattice.hpp"

namespace tektite::test {

/// The gradient that a sum over a square lattice gives to a field of slope one: -Σ δ^D x ∂W/∂x at this ratio of
/// smoothing length to spacing. Uncorrected kernels miss one by a part that depends on the smoothing ratio and not on
/// the spacing, and so do speeds of long waves and spins, which are proportional to it.
template <class K, int D>
double lattice_slope(double ratio = smoothing_ratio) {
  const int reach = static_cast<int>(std::ceil(K::support * ratio));
  double slope = 0.0;
  for (int x = -reach; x <= reach; ++x)
    for (int y = D > 1 ? -reach : 0; y <= (D > 1 ? reach : 0); ++y)
      for (int z = D > 2 ? -reach : 0; z <= (D > 2 ? reach : 0); ++z) {
        const double r = std::sqrt(static_cast<double>(x * x + y * y + z * z));
        if (r > 0.0) slope -= x * x / r * kernel_slope<K, D>(r, ratio);
      }
  return slope;
}

}  // namespace tektite::test
