#pragma once

#include "passes/contact_pair.hpp"

namespace tektite {

/// The forces -∇φ of bodies that started apart, with the curvature of φ, which limits the time step.
template <class Kernel, int D>
struct ContactForces {
  ContactPotential<Kernel, D> potential;
  const double* mass;
  Vector<double, D>* acceleration;  ///< is added to; null where the energy alone is wanted
  double* stiffness;                ///< N/m; null where the energy alone is wanted
  double* energy;                   ///< this particle's half, J

  using Self = typename ContactPotential<Kernel, D>::Self;
  struct Sums {
    Vector<Pack, D> force = Vector<Pack, D>::zero();
    Pack stiffness = 0.0;
    Pack energy = 0.0;
  };

  Self begin(std::size_t i) const { return potential.self(i); }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto pair = potential.pair(a, j);
    for (int k = 0; k < D; ++k) sums.force[k] -= pair.slope[k];
    sums.energy += pair.energy;
    sums.stiffness += pair.curvature;
  }

  void end(std::size_t i, const Sums& sums) const {
    energy[i] = 0.5 * sum(sums.energy);
    if (!acceleration) return;
    for (int k = 0; k < D; ++k) acceleration[i][k] += sum(sums.force[k]) / mass[i];
    stiffness[i] = sum(sums.stiffness);
  }
};

}  // namespace tektite
