#pragma once
// Rings about the axis of an axisymmetric space: what they stretch by, as a neighbourhood sees it.

#include <cstdint>
#include <numbers>

#include "core/pack.hpp"
#include "passes/eulerian_record.hpp"
#include "passes/gathered.hpp"
#include "passes/kernel_pair.hpp"

namespace tektite {

/// What a particle of the section shows of its ring: its place, the area of the section, and numbers that are odd in
/// the radius, such as the radial velocity.
template <int numbers>
struct RingRecord {
  Vector<double, 2> x;      ///< radius and height, m
  double area;              ///< A, m²
  double smoothing_length;  ///< h, m
  Vector<double, numbers> odd;

  void mirror(int axis, double at) {
    x[axis] = 2.0 * at - x[axis];
    if (axis == 0)
      for (int k = 0; k < numbers; ++k) odd[k] = -odd[k];
  }
};

/// Mean radius of the ring that a particle stands for. One on the axis has half a cell (preprocess gives it that mass).
inline double mean_radius(double radius, double spacing) { return radius > 0.0 ? radius : 0.25 * spacing; }

/// Circumference of a ring of this mean radius, m.
inline double circumference(double radius) { return 2.0 * std::numbers::pi * radius; }

/// 𝓢f_a = f_a + Σ A_b W_ab (f_b - f_a) of the odd numbers, and the mean offset Σ A_b W_ab (x_b - x_a) of the
/// neighbours. 𝓢 is its own adjoint under the weights A, so that the rate 𝓢v_r/r of a ring belongs to the force -2π A
/// 𝓢σ_θθ.
template <class Kernel, int numbers>
struct RingSums {
  const RingRecord<numbers>* records;
  Vector<double, numbers>* smoothed;
  Vector<double, 2>* offset;  ///< m; null where nobody asks

  struct Self {
    Vector<Pack, 2> x;
    Vector<Pack, numbers> odd;
    Pack h;
  };
  struct Sums {
    Vector<Pack, numbers> change = Vector<Pack, numbers>::zero();
    Vector<Pack, 2> offset = Vector<Pack, 2>::zero();
  };

  Self begin(std::size_t i) const {
    const auto& r = records[i];
    return {broadcast(r.x), broadcast(r.odd), r.smoothing_length};
  }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    using Record = RingRecord<numbers>;
    const auto x = gathered(records, j, &Record::x) - a.x;
    const KernelPair<Kernel, 2> pair(x, Pack(0.5) * (a.h + gathered(records, j, &Record::smoothing_length)));
    const Pack weight = gathered(records, j, &Record::area) * pair.value * is_other(x);
    const auto other = gathered(records, j, &Record::odd);
    for (int k = 0; k < numbers; ++k) sums.change[k] += weight * (other[k] - a.odd[k]);
    for (int k = 0; k < 2; ++k) sums.offset[k] += weight * x[k];
  }

  void end(std::size_t i, const Sums& sums) const {
    for (int k = 0; k < numbers; ++k) smoothed[i][k] = records[i].odd[k] + sum(sums.change[k]);
    if (offset)
      for (int k = 0; k < 2; ++k) offset[i][k] = sum(sums.offset[k]);
  }
};

}  // namespace tektite
