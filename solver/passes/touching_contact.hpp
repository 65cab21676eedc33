#pragma once
// Contact of bodies that touch at the start. There the kernels of both reach across the faces, and the potential of
// Young et al. (2021), eq. 15, would drive them apart at rest. A particle's half of it, E_a = Σ_b φ_ab/2, is therefore
// counted from what the particle that is pressed most has at the start, E*_a in its volume:
//
//   G_a = E_a - E*_a - E*_a ln(E_a/E*_a) above E*_a, zero below;  dG_a/dE_a = 1 - E*_a/E_a
//
// No force at the start nor when they part, one that grows from zero when they come nearer, and the potential of eq. 15
// where E*_a = 0. The sum over a particle's neighbours, and not each pair, is measured, so that faces may slide:
// a particle of a face has nearly the same sum wherever it is on the other face.

#include <cmath>

#include "passes/contact_pair.hpp"

namespace tektite {

/// Of one particle, over its neighbours of one other body.
struct ContactSum {
  double energy = 0.0;  ///< E_a, J
  double slope = 0.0;   ///< Σ_b |∇φ_ab|/2, N
};

/// What neighbours read of that.
struct ContactShare {
  double weight = 0.0;  ///< dG_a/dE_a
  double bend = 0.0;    ///< d²G_a/dE_a² Σ_b |∇φ_ab|/2, 1/m
  void mirror(int, double) {}
};

/// G_a in J; `at_start` is E*_a in J, above zero.
inline double energy_since_start(double energy, double at_start) {
  if (energy <= at_start) return 0.0;
  const double above = (energy - at_start) / at_start;
  return at_start * (above - std::log1p(above));
}
inline ContactShare share_of(const ContactSum& sum, double at_start) {
  if (sum.energy <= at_start) return {};
  return {1.0 - at_start / sum.energy, at_start / (sum.energy * sum.energy) * sum.slope};
}

/// The sums that shares follow from.
template <class Kernel, int D>
struct ContactSums {
  ContactPotential<Kernel, D> potential;
  ContactSum* result;

  using Self = typename ContactPotential<Kernel, D>::Self;
  struct Sums {
    Pack energy = 0.0, slope = 0.0;
  };

  Self begin(std::size_t i) const { return potential.self(i); }
  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    using std::experimental::sqrt;
    const auto pair = potential.pair(a, j);
    sums.energy += pair.energy;
    sums.slope += sqrt(dot(pair.slope, pair.slope));
  }
  void end(std::size_t i, const Sums& sums) const { result[i] = {0.5 * sum(sums.energy), 0.5 * sum(sums.slope)}; }
};

/// The forces -∂/∂x_a Σ G, of a pair -(w_a + w_b)/2 ∇φ, and half the largest sum that a row of the second derivatives
/// of Σ G can have, which limits the time step as the curvature of eq. 15 does.
template <class Kernel, int D>
struct TouchingForces {
  ContactPotential<Kernel, D> potential;
  const ContactShare* shares;
  const double* mass;
  Vector<double, D>* acceleration;  ///< is added to
  double* stiffness;                ///< N/m, is added to

  struct Self {
    typename ContactPotential<Kernel, D>::Self own;
    Pack weight, bend;
  };
  struct Sums {
    Vector<Pack, D> force = Vector<Pack, D>::zero();
    Pack stiffness = 0.0;
  };

  Self begin(std::size_t i) const { return {potential.self(i), shares[i].weight, shares[i].bend}; }
  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    using std::experimental::sqrt;
    const auto pair = potential.pair(a.own, j);
    const Pack weight = Pack(0.5) * (a.weight + gathered(shares, j, &ContactShare::weight));
    const Pack bend = Pack(0.5) * (a.bend + gathered(shares, j, &ContactShare::bend));
    for (int k = 0; k < D; ++k) sums.force[k] -= weight * pair.slope[k];
    sums.stiffness += weight * pair.curvature + bend * sqrt(dot(pair.slope, pair.slope));
  }
  void end(std::size_t i, const Sums& sums) const {
    for (int k = 0; k < D; ++k) acceleration[i][k] += sum(sums.force[k]) / mass[i];
    stiffness[i] += sum(sums.stiffness);
  }
};

}  // namespace tektite
