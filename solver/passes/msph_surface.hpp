#pragma once

#include <cstdint>

#include "boundary/anvil.hpp"
#include "passes/eulerian_record.hpp"

namespace tektite {

/// Free surfaces of a body, found anew in every step: a particle whose neighbours' mean place is off its own by more
/// than `surface_offset` smoothing lengths has none on one side. On a square lattice with h = 1.5 spacings a particle
/// on a flat surface is off by 0.35 h, one in the second layer by 0.09 h, and none inside.
inline constexpr double surface_offset = 0.2;

/// The stress that the sums see: free of traction on a free surface (Batra and Zhang 2008, section 4.2: turned to the
/// normal n of the surface, the components that act across it set to zero, turned back, which is
///   σ - n ⊗ σn - σn ⊗ n + (n·σn) n ⊗ n),
/// and on a smooth wall free of shear along it. Also who the wall holds.
template <int D>
struct MsphSurface {
  const Vector<double, D>* lopsidedness;
  const Vector<double, D>* velocity;
  Anvil<D> anvil;
  bool frees;  ///< false: the forces are free of traction by themselves
  EulerianRecord<D>* records;
  std::uint8_t* held;

  void operator()(std::size_t i) const {
    auto& r = records[i];
    auto n = lopsidedness[i];
    const int wall = anvil.axis();
    held[i] = 0;
    if (wall >= 0 && anvil.holds(r.x, r.stress[EulerianRecord<D>::index(wall, wall)])) {
      held[i] = 1;
      if (!frees) return;
      n[wall] = 0.0;
      for (int k = 0; k < D; ++k)
        if (k != wall) r.stress[EulerianRecord<D>::index(k, wall)] = 0.0;
    }
    const double off = norm(n);
    if (!frees || !(off > surface_offset)) return;
    n = (1.0 / off) * n;
    auto traction = Vector<double, D>::zero();
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) traction[a] += r.stress[EulerianRecord<D>::index(a, b)] * n[b];
    const double normal = dot(n, traction);
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b)
        r.stress[EulerianRecord<D>::index(a, b)] -= n[a] * traction[b] + traction[a] * n[b] - normal * n[a] * n[b];
  }
};

}  // namespace tektite
