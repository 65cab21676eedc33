#pragma once
// What the contact of two flat faces bears.

#include <algorithm>

#include "boundary/face_contact.hpp"

namespace tektite {

/// Energy per area of the potential of Young et al. (2021), eq. 15, between the flat faces of two bodies on lattices
/// whose outermost rows are `gap` apart and lie opposite to each other, J/m².
template <class Kernel, int D>
double contact_energy(const Face& own, const Face& other, double factor, int exponent, double gap) {
  const double support = Kernel::support * 0.5 * (own.smoothing_length + other.smoothing_length);
  double sum = 0.0;
  for (double row = gap; row < support; row += own.spacing)  // of the own body, one behind the other
    sum += energy_before_face<Kernel, D>(own, other, factor, exponent, row);
  return own.spacing * sum;
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
