#pragma once

#include "core/tensor.hpp"
#include "passes/eulerian_record.hpp"
#include "passes/gathered.hpp"

namespace tektite {

/// What a viscosity that reconstructs velocities needs to know of a particle beside the records that all read.
template <int D>
struct StrainRateRecord {
  static constexpr int components = EulerianRecord<D>::stresses;
  Vector<double, components> rate;  ///< the symmetric part of L, in the order of EulerianRecord's stress, 1/s

  void mirror(int axis, double) {
    for (int k = 0; k < D; ++k)
      if (k != axis) {
        auto& across = rate[EulerianRecord<D>::index(axis, k)];
        across = -across;
      }
  }
};

template <int D>
struct NoteStrainRates {
  const Tensor<double, D>* velocity_gradient;
  StrainRateRecord<D>* records;

  void operator()(std::size_t i) const {
    const auto& l = velocity_gradient[i];
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b) records[i].rate[EulerianRecord<D>::index(a, b)] = 0.5 * (l(a, b) + l(b, a));
  }
};

/// x·L x
template <class T, int D, int N>
[[gnu::always_inline]] inline T stretching_along(const Vector<T, D>& x, const Vector<T, N>& rate) {
  T sum = 0.0;
  for (int a = 0; a < D; ++a) {
    sum += rate[a] * x[a] * x[a];
    for (int b = a + 1; b < D; ++b) sum += T(2.0) * rate[EulerianRecord<D>::index(a, b)] * x[a] * x[b];
  }
  return sum;
}

/// The approach v·x, of a pair at x, that a viscosity damps: of one that reconstructs velocities what a linear motion
/// does not explain. `records` are those of the neighbours j, `own` the rates of the particle.
template <class Viscosity, class Records, class Index, class T, int D, int N>
[[gnu::always_inline]] inline T damped_approach(const Records& records, Index j, const Vector<T, N>& own,
                                                const Vector<T, D>& x, const T& approach) {
  if constexpr (Viscosity::reconstructs)
    return Viscosity::reconstructed(approach, stretching_along(x, own),
                                    stretching_along(x, gathered(records, j, &StrainRateRecord<D>::rate)));
  else
    return approach;
}

}  // namespace tektite
