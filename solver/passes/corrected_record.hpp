#pragma once

#include "passes/correction.hpp"
#include "passes/eulerian_record.hpp"

namespace tektite {

/// What an Eulerian pair needs to know of a particle where gradients are corrected, artificial stress acts, or not all
/// neighbours are Eulerian.
template <int D>
struct CorrectedRecord : EulerianRecord<D> {
  Correction<double, D> correction;
  double artificial[EulerianRecord<D>::stresses];  ///< R in the order of `stress`, m⁵/(kg s²)
  double spacing;                                  ///< Δp, m
  double eulerian;                                 ///< 1 where its kernel is Eulerian, else 0
  double pushes;  ///< 1 where artificial stress acts between it and an Eulerian particle, else 0

  void mirror(int axis, double at) {
    EulerianRecord<D>::mirror(axis, at);
    correction.mirror(axis);
    EulerianRecord<D>::mirror_stress(artificial, axis);
  }
};

}  // namespace tektite
