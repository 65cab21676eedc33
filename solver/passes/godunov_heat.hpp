#pragma once

#include "core/tensor.hpp"

namespace tektite {

/// What a step of a Godunov scheme heats, so that it conserves energy: the time-split Godunov paper, eq. 34. Where
/// `contact` is given, Δv is by both, and the work of the force between bodies, which is not of the pairs, does not
/// heat: its potential takes it, as in a leapfrog. Where the place moves before Δv, the potential sees nothing of the
/// kick by the deviatoric stress that a contact holds in balance step by step: half of the work along it heats, as much
/// as the pairs book too little.
template <int D>
struct GodunovHeat {
  const Vector<double, D>* acceleration;  ///< by the pairs
  const Vector<double, D>* contact;       ///< by the force between bodies; may be null
  const Vector<double, D>* deviatoric;    ///< by the deviatoric half, where the place moves before Δv; may be null
  const double* power;                    ///< of the pair sums, W/kg
  double step;

  /// Δv, m/s
  Vector<double, D> change(std::size_t i) const {
    return step * (contact ? acceleration[i] + contact[i] : acceleration[i]);
  }

  /// W/kg
  double operator()(std::size_t i) const {
    const double heat = power[i] - 0.5 * dot(change(i), acceleration[i]);
    return deviatoric ? heat + 0.5 * step * dot(contact[i], deviatoric[i]) : heat;
  }
};

}  // namespace tektite
