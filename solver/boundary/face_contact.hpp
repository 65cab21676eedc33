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

/// The potential of Young et al. (2021), eq. 15, per volume of a particle before the flat face of an `other` body,
/// J/m³: the sum over a lattice whose outermost row lies, opposite to the particle, so far away.
template <class Kernel, int D>
double energy_before_face(const Face& own, const Face& other, double factor, int exponent, double distance) {
  const double spacing = 0.5 * (own.spacing + other.spacing), delta = other.spacing;
  const double h = 0.5 * (own.smoothing_length + other.smoothing_length);
  const double at_spacing = Kernel::shape(spacing / h);
  const int along = static_cast<int>(Kernel::support * h / delta) + 1;
  double sum = 0.0;
  for (int layer = 0; layer <= along; ++layer)
    for (int y = D > 1 ? -along : 0; y <= (D > 1 ? along : 0); ++y)
      for (int z = D > 2 ? -along : 0; z <= (D > 2 ? along : 0); ++z) {
        const double q = std::hypot(distance + layer * delta, y * delta, z * delta) / h;
        if (q < Kernel::support) sum += std::pow(Kernel::shape(q) / at_spacing, exponent);
      }
  const double modulus = factor * std::min(own.bulk_modulus, other.bulk_modulus);
  return modulus * std::pow(delta / spacing, D) * sum;
}

/// Half of that of a particle in the face of a body that touches the other one: rows lie half a spacing of each behind
/// their faces.
template <class Kernel, int D>
double energy_at_face(const Face& own, const Face& other, double factor, int exponent) {
  const double spacing = 0.5 * (own.spacing + other.spacing);
  return 0.5 * energy_before_face<Kernel, D>(own, other, factor, exponent, spacing);
}

}  // namespace tektite
