#pragma once
// What every scheme asks of all its particles: the smallest stable time step, the range of h, and the ledger.

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "parallel/reduce.hpp"
#include "parallel/sums.hpp"
#include "passes/acoustic_step_limit.hpp"
#include "passes/energy_sums.hpp"
#include "passes/time_step_limit.hpp"
#include "passes/vector_box.hpp"
#include "schemes/scheme.hpp"

namespace tektite {

/// Smallest and largest h.
inline std::pair<double, double> smoothing_range(const Particles& particles) {
  using Bounds = std::pair<double, double>;
  const double* h = particles.scalars(Field::smoothing_length);
  const auto join = [](Bounds& whole, const Bounds& part) {
    whole = {std::min(whole.first, part.first), std::max(whole.second, part.second)};
  };
  return reduce(
      particles, Bounds{std::numeric_limits<double>::infinity(), 0.0},
      [=](Bounds& range, std::size_t i) {
        join(range, {h[i], h[i]});
      },
      join);
}

/// The smallest stable time step of the particles by themselves.
template <int D>
typename TimeStepLimit<D>::Least least_stable_step(const Particles& p, double courant, const MonaghanPair& viscosity) {
  const TimeStepLimit<D> pass{p.integers(Field::id).data(),
                              courant,
                              viscosity.alpha,
                              viscosity.beta,
                              p.scalars(Field::smoothing_length),
                              p.scalars(Field::wave_speed),
                              p.scalars(Field::sound_speed),
                              p.scalars(Field::viscous_signal),
                              p.scalars(Field::density),
                              p.vectors<D>(Field::acceleration),
                              p.has(Field::least_stretch) ? p.scalars(Field::least_stretch) : nullptr};
  return reduce(p, typename TimeStepLimit<D>::Least{}, pass, TimeStepLimit<D>::join);
}

/// The same for a scheme without viscosity; motion(i) is the speed in m/s that adds to that of sound.
template <int D, class Motion>
typename TimeStepLimit<D>::Least least_acoustic_step(const Particles& p, double courant, const Motion& motion) {
  const AcousticStepLimit<D, Motion> pass{p.integers(Field::id).data(),       courant,
                                          p.scalars(Field::smoothing_length), p.scalars(Field::wave_speed),
                                          p.scalars(Field::density),          motion};
  return reduce(p, typename TimeStepLimit<D>::Least{}, pass, TimeStepLimit<D>::join);
}

/// The step in s in which no two particles, and none and a wall or its image there, come nearer to each other by more
/// than the least smoothing length. It is seldom the smallest one, but bodies of a gas that is too cold to have a sound
/// speed would pass through each other without it.
template <int D>
double meeting_step(const Particles& p, std::span<const SymmetryPlane> walls) {
  struct Extremes {
    VectorBox<D> velocities{};
    double least_smoothing = std::numeric_limits<double>::infinity();
  };
  const auto extremes = reduce(
      p, Extremes{},
      [v = p.vectors<D>(Field::velocity), h = p.scalars(Field::smoothing_length)](Extremes& so_far, std::size_t i) {
        so_far.velocities.take(v[i]);
        so_far.least_smoothing = std::min(so_far.least_smoothing, h[i]);
      },
      [](Extremes& whole, const Extremes& part) {
        VectorBox<D>::join(whole.velocities, part.velocities);
        whole.least_smoothing = std::min(whole.least_smoothing, part.least_smoothing);
      });
  return limit_of(extremes.least_smoothing, extremes.velocities.diagonal(walls));
}

/// The id of the fastest particle; of several the least.
template <int D>
std::int64_t fastest_particle(const Particles& p) {
  struct Fastest {
    double square = -1.0;
    std::int64_t id = 0;
  };
  const auto join = [](Fastest& whole, const Fastest& part) {
    if (part.square > whole.square || (part.square == whole.square && part.id < whole.id)) whole = part;
  };
  return reduce(
             p, Fastest{},
             [=, v = p.vectors<D>(Field::velocity), id = p.integers(Field::id).data()](Fastest& fastest,
                                                                                       std::size_t i) {
               join(fastest, {dot(v[i], v[i]), id[i]});
             },
             join)
      .id;
}

/// The smallest of a step, that in which particles meet, and that of the contact between bodies, if there is one.
template <int D, class Contact>
TimeStep smallest_step(typename TimeStepLimit<D>::Least least, const Particles& p, std::span<const SymmetryPlane> walls,
                       const std::optional<Contact>& contact, double courant) {
  if (const double dt = meeting_step<D>(p, walls); dt < least.dt) {
    least = {dt, fastest_particle<D>(p), StepLimit::meeting};
  }
  if (contact) {
    const auto limit = contact->stable_step(courant);
    if (limit.dt < least.dt) least = limit;
  }
  return {least.dt, least.reason, least.particle};
}

/// Is asked again and again for energies and momentum.
template <int D>
class LedgerSums {
 public:
  /// `contact` is what is stored between bodies, J.
  Ledger operator()(const Particles& p, double contact) {
    const EnergySums<D> pass{p.scalars(Field::mass), p.vectors<D>(Field::velocity),
                             p.scalars(Field::specific_internal_energy),
                             p.has(Field::plastic_work) ? p.scalars(Field::plastic_work) : nullptr,
                             p.has(Field::viscous_work) ? p.scalars(Field::viscous_work) : nullptr};
    const auto sums = sum_(p, pass);
    return {sums[0], sums[1], sums[2], sums[3], contact, {sums.begin() + 4, sums.end()}};
  }

 private:
  RepeatedSum<EnergySums<D>::count> sum_;
};

}  // namespace tektite
