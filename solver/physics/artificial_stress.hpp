#pragma once

#include <cmath>

#include "core/tensor.hpp"

namespace tektite {

/// Between which particles artificial stress acts where Eulerian and total-Lagrangian ones meet.
enum class ArtificialStressInterface { none, both, eulerian };

/// Monaghan's remedy for the tensile instability as Gray et al. (2001) use it in the plane; Young et al. (2021), eq. 10
/// and 11. A pair's acceleration has their factor 1/2, so ε = 0.3 here is 0.15 in the scale of Gray et al.
struct ArtificialStress {
  double epsilon = 0.3;
  int exponent = 4;  ///< n_as
  ArtificialStressInterface interface = ArtificialStressInterface::both;

  /// R = -ε σ⁺/ρ², where σ⁺ are the tensile ones of the principal stresses in the plane, in m⁵/(kg s²). `out` has the
  /// components xx, yy, xy; so has `stress`, in Pa.
  void tensor(const double (&stress)[3], double density, double (&out)[3]) const {
    const double mean = 0.5 * (stress[0] + stress[1]), half = 0.5 * (stress[0] - stress[1]);
    const double radius = std::sqrt(half * half + stress[2] * stress[2]);
    const double scale = -epsilon / (density * density);
    const double first = scale * std::fmax(mean + radius, 0.0), second = scale * std::fmax(mean - radius, 0.0);
    const double around = 0.5 * (first + second);
    const double along = radius > 0.0 ? 0.5 * (first - second) / radius : 0.0;
    out[0] = around + along * half;
    out[1] = around - along * half;
    out[2] = along * stress[2];
  }
};

}  // namespace tektite
