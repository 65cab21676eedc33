#pragma once
// What the contact of two flat faces bears.

#include <algorithm>
#include <cmath>

#include "boundary/face_contact.hpp"

namespace tektite {

/// Energy per area of the potential of Young et al. (2021), eq. 15, between the flat faces of two bodies on lattices
/// whose outermost rows are `gap` apart and lie opposite to each other, J/m².
template <class Kernel, int D>
double contact_energy(const Face& own, const Face& other, double factor, int exponent, double gap) {
  const double spacing = 0.5 * (own.spacing + other.spacing), delta = other.spacing;
  const double h = 0.5 * (own.smoothing_length + other.smoothing_length);
  const double at_spacing = Kernel::shape(spacing / h);
  const int along = static_cast<int>(Kernel::support * h / delta) + 1;
  double sum = 0.0;
  for (double x = gap; x < Kernel::support * h; x += own.spacing)  // row behind row of `own` ...
    for (double z = x; z < Kernel::support * h; z += delta)        // ... before row behind row of `other`
      for (int i = D > 1 ? -along : 0; i <= (D > 1 ? along : 0); ++i)
        for (int j = D > 2 ? -along : 0; j <= (D > 2 ? along : 0); ++j) {
          const double q = std::hypot(z, i * delta, j * delta) / h;
          if (q < Kernel::support) sum += std::pow(Kernel::shape(q) / at_spacing, exponent);
        }
  const double modulus = factor * std::min(own.bulk_modulus, other.bulk_modulus);
  return modulus * std::pow(delta / spacing, D) * own.spacing * sum;
}

/// The largest pressure that it has, Pa, over the gap: what presses the faces together by more is not held.
template <class Kernel, int D>
double largest_contact_pressure(const Face& own, const Face& other, double factor, int exponent) {
  constexpr int steps = 100;
  const double step = Kernel::support * 0.5 * (own.smoothing_length + other.smoothing_length) / steps;
  double largest = 0.0, before = contact_energy<Kernel, D>(own, other, factor, exponent, 0.0);
  for (int n = 1; n <= steps; ++n) {
    const double energy = contact_energy<Kernel, D>(own, other, factor, exponent, n * step);
    largest = std::max(largest, (before - energy) / step);
    before = energy;
  }
  return largest;
}

}  // namespace tektite
