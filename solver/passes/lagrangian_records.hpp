#pragma once

#include "core/tensor.hpp"
#include "passes/correction.hpp"
#include "passes/eulerian_record.hpp"

namespace tektite {

/// What a total-Lagrangian pair needs of the reference configuration; made once, but for the kernel type.
template <int D>
struct ReferenceRecord {
  Vector<double, D> x;  ///< X, m
  double volume;        ///< V_0
  double smoothing_length;
  double lagrangian;                 ///< 1 where its kernel is of the reference configuration, 0 where it is Eulerian
  Correction<double, D> correction;  ///< stands last

  void mirror(int axis, double at) {
    x[axis] = 2.0 * at - x[axis];
    correction.mirror(axis);
  }
};

/// Place and velocity in the middle of a step.
template <int D>
struct MotionRecord {
  Vector<double, D> x;  ///< m
  Vector<double, D> v;  ///< m/s

  void mirror(int axis, double at) { mirror_motion(*this, axis, at); }
};

/// What it acts with.
template <int D>
struct StressRecord {
  Tensor<double, D> stress;    ///< first Piola-Kirchhoff stress P = J σ F⁻ᵀ, Pa
  Tensor<double, D> cofactor;  ///< J F⁻ᵀ
  double jacobian;             ///< J
  double density;              ///< ρ
  double sound_speed;          ///< c, bulk
  double least_stretch;        ///< the smallest principal one of F, at most 1

  void mirror(int axis, double) {
    mirror_tensor(stress, axis);
    mirror_tensor(cofactor, axis);
  }
};

}  // namespace tektite
