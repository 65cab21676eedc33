#pragma once

#include <algorithm>
#include <cmath>

namespace tektite {

/// What the contact needs of a body to tell where its face lies.
struct Face {
  double bulk_modulus = 0.0;      ///< Pa
  double smoothing_length = 0.0;  ///< m
  double spacing = 0.0;           ///< m
};

/// Half of the potential of Young et al. (2021), eq. 15, per volume of a particle in the face of a body, where that
/// touches the flat face of an `other` one, J/m³: the sum over a lattice whose outermost row lies, opposite to the
/// particle, half a spacing of each behind the faces.
template <class Kernel, int D>
double energy_at_face(const Face& own, const Face& other, double factor, int exponent) {
  const double spacing = 0.5 * (own.spacing + other.spacing), delta = other.spacing;
  const double h = 0.5 * (own.smoothing_length + other.smoothing_length);
  const double at_spacing = Kernel::shape(spacing / h);
  const int along = static_cast<int>(Kernel::support * h / delta) + 1;
  double sum = 0.0;
  for (int layer = 0; layer <= along; ++layer)
    for (int y = D > 1 ? -along : 0; y <= (D > 1 ? along : 0); ++y)
      for (int z = D > 2 ? -along : 0; z <= (D > 2 ? along : 0); ++z) {
        const double q = std::hypot(spacing + layer * delta, y * delta, z * delta) / h;
        if (q < Kernel::support) sum += std::pow(Kernel::shape(q) / at_spacing, exponent);
      }
  const double modulus = factor * std::min(own.bulk_modulus, other.bulk_modulus);
  return 0.5 * modulus * std::pow(delta / spacing, D) * sum;
}

}  // namespace tektite
