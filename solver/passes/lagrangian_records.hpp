#pragma once

#include "core/tensor.hpp"
#include "passes/reference_pair.hpp"

namespace tektite {

template <int D>
void mirror_tensor(Tensor<double, D>& t, int axis) {
  for (int k = 0; k < D; ++k)
    if (k != axis) {
      t(axis, k) = -t(axis, k);
      t(k, axis) = -t(k, axis);
    }
}

/// What a total-Lagrangian pair needs of the reference configuration; made once.
template <int D>
struct ReferenceRecord {
  Vector<double, D> x;  ///< X, m
  double volume;        ///< V_0
  double smoothing_length;
  Correction<double, D> correction;

  void mirror(int axis, double at) {
    x[axis] = 2.0 * at - x[axis];
    mirror_tensor(correction.matrix, axis);
    correction.shift[axis] = -correction.shift[axis];
  }
};

/// Place and velocity in the middle of a step.
template <int D>
struct MotionRecord {
  Vector<double, D> x;  ///< m
  Vector<double, D> v;  ///< m/s

  void mirror(int axis, double at) {
    x[axis] = 2.0 * at - x[axis];
    v[axis] = -v[axis];
  }
};

/// What it acts with.
template <int D>
struct StressRecord {
  Tensor<double, D> stress;    ///< first Piola-Kirchhoff stress P = J σ F⁻ᵀ, Pa
  Tensor<double, D> cofactor;  ///< J F⁻ᵀ
  double jacobian;             ///< J
  double density;              ///< ρ
  double sound_speed;          ///< c, bulk

  void mirror(int axis, double) {
    mirror_tensor(stress, axis);
    mirror_tensor(cofactor, axis);
  }
};

}  // namespace tektite
