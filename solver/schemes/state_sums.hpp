#pragma once
// What every scheme asks of all its particles: the smallest stable time step, and the ledger.

#include <limits>

#include "parallel/reduce.hpp"
#include "passes/acoustic_step_limit.hpp"
#include "passes/energy_sums.hpp"
#include "passes/time_step_limit.hpp"
#include "schemes/scheme.hpp"

namespace tektite {

/// The smallest stable time step of the particles by themselves.
template <int D>
typename TimeStepLimit<D>::Least least_stable_step(const Particles& p, double courant,
                                                   const MonaghanViscosity& viscosity) {
  const TimeStepLimit<D> pass{courant,
                              viscosity.alpha,
                              viscosity.beta,
                              p.scalars(Field::smoothing_length),
                              p.scalars(Field::wave_speed),
                              p.scalars(Field::sound_speed),
                              p.scalars(Field::viscous_signal),
                              p.scalars(Field::density),
                              p.vectors<D>(Field::acceleration)};
  return reduce(p.count(), typename TimeStepLimit<D>::Least{std::numeric_limits<double>::infinity()}, pass,
                TimeStepLimit<D>::join);
}

/// The same for a scheme without viscosity.
template <int D>
typename TimeStepLimit<D>::Least least_acoustic_step(const Particles& p, double courant) {
  const AcousticStepLimit<D> pass{courant, p.scalars(Field::smoothing_length), p.scalars(Field::wave_speed),
                                  p.scalars(Field::approach_speed), p.scalars(Field::density)};
  return reduce(p.count(), typename TimeStepLimit<D>::Least{std::numeric_limits<double>::infinity()}, pass,
                TimeStepLimit<D>::join);
}

/// Energies and momentum; `contact` is what is stored between bodies, J.
template <int D>
Ledger ledger_of(const Particles& p, double contact) {
  const EnergySums<D> pass{p.scalars(Field::mass), p.vectors<D>(Field::velocity),
                           p.scalars(Field::specific_internal_energy),
                           p.has(Field::plastic_work) ? p.scalars(Field::plastic_work) : nullptr,
                           p.has(Field::viscous_work) ? p.scalars(Field::viscous_work) : nullptr};
  const auto sums = reduce(p.count(), typename EnergySums<D>::Sums{}, pass, EnergySums<D>::join);
  return {sums.kinetic, sums.internal, sums.plastic, sums.viscous, contact, {sums.momentum.c, sums.momentum.c + D}};
}

}  // namespace tektite
