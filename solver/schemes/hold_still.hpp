#pragma once

#include "boundary/mirror.hpp"
#include "parallel/for_each.hpp"
#include "passes/hold_clamped.hpp"

namespace tektite {

/// Clamped particles, and those on a symmetry plane, stay where they have to: takes what would move them from their
/// accelerations, or velocities.
template <int D>
void hold_still(Particles& particles, const Mirror<D>& mirror, Vector<double, D>* rate) {
  if (particles.has(Field::clamped))
    run_through({0, particles.count()}, HoldClamped<D>{particles.integers(Field::clamped).data(), rate});
  mirror.hold(rate);
}

}  // namespace tektite
