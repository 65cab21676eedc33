#pragma once

#include "core/pack.hpp"
#include "core/tensor.hpp"

namespace tektite {

/// Reflects place and velocity of a record at the plane x_axis = at.
template <class Record>
void mirror_motion(Record& record, int axis, double at) {
  record.x[axis] = 2.0 * at - record.x[axis];
  record.v[axis] = -record.v[axis];
}

/// What an Eulerian pair needs to know of a particle, in one piece of memory, at the middle of a step. In plane stress
/// the numbers are those of the membrane: per area, so that density, stress and volume carry the thickness. A record is
/// a whole number of packs long, so that it can be read row by row.
template <int D>
struct alignas(pack_width * sizeof(double)) EulerianRecord {
  static constexpr int stresses = D * (D + 1) / 2;

  Vector<double, D> x;      ///< m
  Vector<double, D> v;      ///< m/s
  double stress[stresses];  ///< σ within the space: xx (yy (zz)) (xy (yz zx)), Pa
  double volume;            ///< V
  double density;           ///< ρ
  double sound_speed;       ///< c, bulk
  double smoothing_length;  ///< h

  /// Index of σ_ij in `stress`.
  static constexpr int index(int i, int j) {
    if (D == 1 || i == j) return D == 1 ? 0 : i;
    return D == 2 ? 2 : (i + j == 1 ? 3 : (i + j == 3 ? 4 : 5));
  }

  /// Reflects a tensor that is kept like `stress`.
  static void mirror_stress(double (&tensor)[stresses], int axis) {
    for (int k = 0; k < D; ++k)
      if (k != axis) tensor[index(axis, k)] = -tensor[index(axis, k)];
  }
  /// Reflects the record at the plane x_axis = at.
  void mirror(int axis, double at) {
    mirror_motion(*this, axis, at);
    mirror_stress(stress, axis);
  }
};

}  // namespace tektite
