#pragma once

#include "core/tensor.hpp"

namespace tektite {

/// What a step of a Godunov scheme heats, so that it conserves energy: the time-split Godunov paper, eq. 34. The pairs
/// take back what they give to the motion. Where `contact` is given, Δv is by both; the potential between bodies gives
/// what its force does along the way of the place, v + c Δv, and what that differs from the change of kinetic energy,
/// along v + ½ Δv, is heat as the same difference of the pairs is: of what they hold in balance both cancel.
template <int D>
struct GodunovHeat {
  const Vector<double, D>* acceleration;  ///< by the pairs
  const Vector<double, D>* contact;       ///< by the force between bodies; may be null
  const double* power;                    ///< of the pair sums, W/kg
  double step;
  double centring;  ///< c

  /// Δv, m/s
  Vector<double, D> change(std::size_t i) const {
    return step * (contact ? acceleration[i] + contact[i] : acceleration[i]);
  }

  /// W/kg
  double operator()(std::size_t i) const {
    auto taken = 0.5 * acceleration[i];
    if (contact) taken += (0.5 - centring) * contact[i];
    return power[i] - dot(change(i), taken);
  }
};

}  // namespace tektite
