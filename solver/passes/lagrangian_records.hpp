#pragma once

#include "core/tensor.hpp"
#include "passes/correction.hpp"
#include "passes/eulerian_record.hpp"

namespace tektite {

/// What a total-Lagrangian pair needs of the reference configuration; made once, but for the kernel type.
template <int D>
struct ReferenceRecord {
  double volume;        ///< V_0
  Vector<double, D> x;  ///< X, m
  double smoothing_length;
  double lagrangian;  ///< 1 where its kernel is of the reference configuration, 0 where it is Eulerian

  void mirror(int axis, double at) { x[axis] = 2.0 * at - x[axis]; }
};

/// Place and velocity in the middle of a step.
template <int D>
struct MotionRecord {
  Vector<double, D> x;  ///< m
  Vector<double, D> v;  ///< m/s

  void mirror(int axis, double at) { mirror_motion(*this, axis, at); }
};

/// What it acts with. Gradients of a corrected kernel are matrix (∇W - shift W): a pair multiplies the plain one by the
/// products that stand here and in the ShiftRecord, and needs no correction of its neighbour.
template <int D>
struct StressRecord {
  double density = 1.0;        ///< ρ; this and the stretch divide, also in a lane that holds no particle
  double sound_speed;          ///< c, bulk
  double least_stretch = 1.0;  ///< by which the viscosity's h has shrunk
  Tensor<double, D> stress;    ///< V_0 P `matrix` with the first Piola-Kirchhoff stress P = J σ F⁻ᵀ, J
  Tensor<double, D> cofactor;  ///< J F⁻ᵀ `matrix`; from the sweep over motions to the stress both are dF/dt and F
  double jacobian;             ///< J

  void mirror(int axis, double) {
    mirror_tensor(stress, axis);
    mirror_tensor(cofactor, axis);
  }
};

/// The rest of it, which there is with a correction only.
template <int D>
struct ShiftRecord {
  Vector<double, D> stress;    ///< the `stress` of the StressRecord times `shift`
  Vector<double, D> cofactor;  ///< its `cofactor` times `shift`

  void mirror(int axis, double) {
    stress[axis] = -stress[axis];
    cofactor[axis] = -cofactor[axis];
  }
};

/// What the control of zero-energy modes needs (passes/hourglass_sums.hpp).
template <int D>
struct HourglassRecord {
  double stiffness;            ///< k, Pa
  Tensor<double, D> gradient;  ///< k G, Pa

  void mirror(int axis, double) { mirror_tensor(gradient, axis); }
};

}  // namespace tektite
