#pragma once

#include <array>

#include "core/tensor.hpp"

namespace tektite {

/// What a particle adds to the ledger: kinetic, internal, plastic and viscous energy in J, and momentum in kg m/s (per
/// metre of thickness in the plane, per square metre on a line).
template <int D>
struct EnergySums {
  static constexpr std::size_t count = 4 + D;

  const double* mass;
  const Vector<double, D>* velocity;
  const double* energy;
  const double* plastic_work;  ///< may be null where nothing yields
  const double* viscous_work;  ///< may be null where nothing is viscous

  std::array<double, count> operator()(std::size_t i) const {
    const double m = mass[i];
    std::array<double, count> terms{0.5 * m * dot(velocity[i], velocity[i]), m * energy[i],
                                    plastic_work ? m * plastic_work[i] : 0.0, viscous_work ? m * viscous_work[i] : 0.0};
    for (int k = 0; k < D; ++k) terms[4 + static_cast<std::size_t>(k)] = m * velocity[i][k];
    return terms;
  }
};

}  // namespace tektite
