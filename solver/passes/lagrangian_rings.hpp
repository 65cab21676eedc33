#pragma once
// What turning about the axis adds to the total-Lagrangian scheme. The strain energy of rings of the reference volume
// 2πR A is a function of F in the section and of the stretch λ of the ring; forces are its derivatives, so that energy
// and the momentum along the axis are kept. With 𝓢 of ring_sums.hpp and the mean offset d of the neighbours,
//   λ = 1 + (𝓢u_r - (F - I)_rb d_b)/R,
// which is exact for linear motions up to the mantle. 𝓢 looks across the axis at images: with u_r/R of the particle
// alone instead, a uniform pressure would drive particles near the axis, because the gradients of the section are
// smoothed there and the ring's would not be.

#include "core/tensor.hpp"
#include "passes/lagrangian_records.hpp"
#include "passes/ring_sums.hpp"

namespace tektite {

/// λ and its rate over λ, in the middle of a step. On the axis they are those of the radius.
struct StretchRings {
  const ReferenceRecord<2>* reference;
  const StressRecord<2>* records;     ///< with F in the section and its rate
  const Vector<double, 2>* smoothed;  ///< 𝓢u_r in m, 𝓢v_r in m/s
  const Vector<double, 2>* offset;    ///< d, m
  double* stretch;                    ///< λ
  double* across_rate;                ///< 1/s

  void operator()(std::size_t i) const {
    const double radius = reference[i].x[0];
    const auto &f = records[i].cofactor, &l = records[i].stress;
    const auto& d = offset[i];
    const bool on_axis = radius == 0.0;
    const double displacement = smoothed[i][0] - (f(0, 0) - 1.0) * d[0] - f(0, 1) * d[1];
    const double speed = smoothed[i][1] - l(0, 0) * d[0] - l(0, 1) * d[1];
    stretch[i] = on_axis ? f(0, 0) : 1.0 + displacement / radius;
    across_rate[i] = (on_axis ? l(0, 0) : speed / radius) / stretch[i];
  }
};

/// Turns the stress of the section into that of a whole ring, 2πr σ in place of σ, and takes for the ring's own force
/// q = 2π J σ_θθ per area. What F has in λ comes back as stress: -q d_b, and on the axis all of it.
struct RingStress {
  const ReferenceRecord<2>* reference;
  const double* circumference;  ///< of the reference configuration, m
  const double* stretch;
  const Vector<double, 2>* offset;
  const Symmetric<double, 2>* half_deviatoric_stress;
  const double* half_pressure;
  StressRecord<2>* records;
  double* hoop_force;  ///< q, Pa

  void operator()(std::size_t i) const {
    auto& r = records[i];
    const double hoop = half_deviatoric_stress[i].c[2] - half_pressure[i];
    const double length = circumference[i] * stretch[i];
    for (auto& component : r.stress.c) component *= length;
    r.density *= length;
    if (reference[i].x[0] == 0.0) {
      hoop_force[i] = 0.0;
      r.stress(0, 0) += circumference[i] * r.jacobian * hoop;
      return;
    }
    hoop_force[i] = 2.0 * std::numbers::pi * r.jacobian * hoop;
    for (int b = 0; b < 2; ++b) r.stress(0, b) -= hoop_force[i] * offset[i][b];
  }
};

}  // namespace tektite
