#pragma once

#include <limits>

#include "core/pack.hpp"
#include "core/tensor_algebra.hpp"
#include "passes/eulerian_record.hpp"
#include "passes/gathered.hpp"

namespace tektite {

/// What the deviatoric half of a time-split step needs to know of a particle. Like every record here it is a whole
/// number of packs long, so that it can be read row by row.
template <int D>
struct alignas(pack_width * sizeof(double)) DeviatoricRecord {
  static constexpr int stresses = EulerianRecord<D>::stresses;

  Vector<double, D> x;      ///< m
  Vector<double, D> v;      ///< m/s
  double stress[stresses];  ///< τ within the space, in the order of EulerianRecord, Pa
  double volume;            ///< m/ρ
  double density;           ///< ρ
  double pressure;          ///< P
  double smoothing_length;  ///< h

  static constexpr int index(int i, int j) { return EulerianRecord<D>::index(i, j); }

  /// Reflects the record at the plane x_axis = at.
  void mirror(int axis, double at) {
    mirror_motion(*this, axis, at);
    EulerianRecord<D>::mirror_stress(stress, axis);
  }
};

/// What the hydrodynamic half needs; the gradients, of the state at the start of the step (with corrected sums that of
/// the velocity is of ṽ), are read in second order only.
template <int D>
struct alignas(pack_width * sizeof(double)) HydrodynamicRecord {
  Vector<double, D> x;      ///< m
  Vector<double, D> v;      ///< ṽ, m/s
  double density;           ///< ρ
  double pressure;          ///< P
  double sound_speed;       ///< c, bulk
  double shock_slope;       ///< A
  double inverse_slope;     ///< 1/A
  double volume;            ///< m/ρ
  double smoothing_length;  ///< h
  double failed;            ///< 1 where D = 1, otherwise 0
  Vector<double, D> density_gradient;
  Vector<double, D> pressure_gradient;
  Tensor<double, D> velocity_gradient;

  /// Numbers before the gradients.
  static constexpr std::size_t plain = 2 * D + 8;

  void mirror(int axis, double at) {
    mirror_motion(*this, axis, at);
    density_gradient[axis] = -density_gradient[axis];
    pressure_gradient[axis] = -pressure_gradient[axis];
    mirror_tensor(velocity_gradient, axis);
  }
};

/// What the contacts of Parshikov and Medin need.
template <int D>
struct alignas(pack_width * sizeof(double)) ContactStateRecord {
  static constexpr int stresses = EulerianRecord<D>::stresses;

  Vector<double, D> x;      ///< m
  Vector<double, D> v;      ///< m/s
  double stress[stresses];  ///< σ within the space, in the order of EulerianRecord, Pa
  double volume;            ///< m/ρ
  double longitudinal;      ///< z_l = ρ c_l, kg/(m² s)
  double transverse;        ///< z_t = ρ c_t; zero for a fluid
  double smoothing_length;  ///< h
  double failed;            ///< 1 where D = 1, otherwise 0

  static constexpr int index(int i, int j) { return EulerianRecord<D>::index(i, j); }

  void mirror(int axis, double at) {
    mirror_motion(*this, axis, at);
    EulerianRecord<D>::mirror_stress(stress, axis);
  }
};

/// A pair as the Godunov schemes see it: the unit vector e_ij from j to i (zero where i meets itself), the distance and
/// the kernel's slope.
template <class Kernel, int D>
struct PairAxis {
  Vector<Pack, D> e;
  Pack distance;
  Pack slope;  ///< dW/dr, so that ∇W = slope e; zero beyond the support

  PairAxis(const Vector<Pack, D>& x, const Pack& inverse_h) : distance(sqrt(dot(x, x))) {
    // 0/0 is avoided: where i meets itself, e is 0 times this.
    const Pack inverse = Pack(1.0) / larger(distance, Pack(std::numeric_limits<double>::min()));
    for (int k = 0; k < D; ++k) e[k] = inverse * x[k];
    const Pack q = distance * inverse_h;
    Pack scale = inverse_h * Pack(Kernel::template normalisation<D>());
    for (int k = 0; k < D; ++k) scale *= inverse_h;
    slope = select(q < Pack(Kernel::support), scale * Kernel::slope(q), Pack(0.0));
    slope = select(distance > Pack(0.0), slope, Pack(0.0));
  }
};

}  // namespace tektite
