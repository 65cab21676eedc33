#pragma once

#include "boundary/mirror.hpp"
#include "parallel/for_each.hpp"
#include "passes/hold_clamped.hpp"

namespace tektite {

/// Clamped particles, and those on a symmetry plane, stay where they have to: takes that from their accelerations.
template <int D>
void hold_still(Particles& particles, const Mirror<D>& mirror, Vector<double, D>* acceleration) {
  if (particles.has(Field::clamped))
    run_through({0, particles.count()}, HoldClamped<D>{particles.integers(Field::clamped).data(), acceleration});
  mirror.hold(acceleration);
}

}  // namespace tektite
