#pragma once

#include "core/tensor.hpp"

namespace tektite {

/// The ledger: energies in J and momentum in kg m/s (per metre of thickness in the plane, per square metre on a line).
template <int D>
struct EnergySums {
  struct Sums {
    double kinetic = 0.0;
    double internal = 0.0;
    double plastic = 0.0;
    double viscous = 0.0;
    Vector<double, D> momentum = Vector<double, D>::zero();
  };

  const double* mass;
  const Vector<double, D>* velocity;
  const double* energy;
  const double* plastic_work;  ///< may be null where nothing yields
  const double* viscous_work;  ///< may be null where nothing is viscous

  void operator()(Sums& sums, std::size_t i) const {
    const double m = mass[i];
    sums.kinetic += 0.5 * m * dot(velocity[i], velocity[i]);
    sums.internal += m * energy[i];
    if (plastic_work) sums.plastic += m * plastic_work[i];
    if (viscous_work) sums.viscous += m * viscous_work[i];
    sums.momentum += m * velocity[i];
  }
  static void join(Sums& whole, const Sums& part) {
    whole.kinetic += part.kinetic;
    whole.internal += part.internal;
    whole.plastic += part.plastic;
    whole.viscous += part.viscous;
    whole.momentum += part.momentum;
  }
};

}  // namespace tektite
