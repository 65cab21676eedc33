#pragma once

#include <cmath>

#include "core/tensor_algebra.hpp"
#include "core/tensor_product.hpp"
#include "passes/across.hpp"
#include "passes/lagrangian_records.hpp"

namespace tektite {

/// x½ = x + v dt/2,  v½ = v + a dt/2.
template <int D>
struct PredictLagrangianMotion {
  const Vector<double, D>* position;
  const Vector<double, D>* velocity;
  const Vector<double, D>* acceleration;
  double half_step;
  MotionRecord<D>* records;

  void operator()(std::size_t i) const {
    records[i].x = position[i] + half_step * velocity[i];
    records[i].v = velocity[i] + half_step * acceleration[i];
  }
};

/// From F and its rate in the middle of a step: cofactor and J, L = Ḟ F⁻¹, the density m/(V_0 J) and the energy there,
/// e + (σ:L/ρ + q) dt/2 with the stress at the step's beginning. An Eulerian particle's density and energy follow from
/// the L of the step before, and its J from its density. Rings stretch along themselves too: their volume is V_0 J λ,
/// and F, J and L are those of the section.
template <int D, bool rings>
struct Deform {
  const ReferenceRecord<D>* reference;  ///< without volume where the particle has failed: it is not deformed any more
  const double* mass;
  const double* reference_volume;
  const double* density;
  const double* energy;
  const double* pressure;
  const Symmetric<double, D>* deviatoric_stress;
  const double* viscous_power;
  const double* stretch;  ///< λ of rings
  double* across_rate;    ///< of rings, 1/s
  double half_step;
  StressRecord<D>* records;
  Tensor<double, D>* deformation;  ///< takes F, which leaves the record; null where nobody asks for it later
  Tensor<double, D>* velocity_gradient;
  double* half_density;
  double* half_energy;

  void operator()(std::size_t i) const {
    auto& r = records[i];
    auto& l = velocity_gradient[i];
    const auto f = r.cofactor;
    if (deformation) deformation[i] = f;
    if (reference[i].volume == 0.0) {
      r.cofactor = Tensor<double, D>::zero();
      r.jacobian = 1.0;
      l = Tensor<double, D>::zero();
      if constexpr (rings) across_rate[i] = 0.0;
      half_density[i] = density[i];
      half_energy[i] = energy[i];
      return;
    }
    r.cofactor = cofactor(f);
    if (reference[i].lagrangian != 0.0) {
      r.jacobian = determinant(f);
      l = product_with_transposed(r.stress, r.cofactor);  // F⁻¹ = Cᵀ/J
      const double inverse = 1.0 / r.jacobian;
      for (auto& component : l.c) component *= inverse;
      half_density[i] = mass[i] / (reference_volume[i] * r.jacobian);
      if constexpr (rings) half_density[i] /= stretch[i];
    } else {
      half_density[i] = density[i] * density_factor(half_step * trace(l));
      r.jacobian = mass[i] / (reference_volume[i] * half_density[i]);
    }
    double power = contract(deviatoric_stress[i], symmetric_part(l)) - pressure[i] * trace(l);
    if constexpr (rings) power += (deviatoric_stress[i].c[2] - pressure[i]) * across_rate[i];
    half_energy[i] = energy[i] + half_step * (power / density[i] + viscous_power[i]);
  }
};

/// P = J σ F⁻ᵀ in the middle of a step for `stress`, and what the viscosity needs.
template <int D>
struct AssembleStress {
  const Symmetric<double, D>* half_deviatoric_stress;
  const double* half_pressure;
  const double* half_density;
  const double* half_sound_speed;
  StressRecord<D>* records;

  void operator()(std::size_t i) const {
    auto& r = records[i];
    auto sigma = half_deviatoric_stress[i];
    for (int k = 0; k < 3; ++k) sigma.c[k] -= half_pressure[i];
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) {
        double sum = 0.0;
        for (int k = 0; k < D; ++k) sum += sigma(a, k) * r.cofactor(k, b);
        r.stress(a, b) = sum;
      }
    r.density = half_density[i];
    r.sound_speed = half_sound_speed[i];
  }
};

/// Brings volume and correction into what acts on neighbours: `stress` and `cofactor` are P and J F⁻ᵀ before.
template <int D, bool corrected>
struct WeighStress {
  const ReferenceRecord<D>* reference;
  const Correction<double, D>* corrections;
  StressRecord<D>* records;
  ShiftRecord<D>* shifts;

  void operator()(std::size_t i) const {
    auto& r = records[i];
    for (auto& component : r.stress.c) component *= reference[i].volume;
    if constexpr (corrected) {
      const auto& correction = corrections[i];
      r.stress = product(r.stress, correction.matrix);
      r.cofactor = product(r.cofactor, correction.matrix);
      shifts[i] = {times(r.stress, correction.shift), times(r.cofactor, correction.shift)};
    }
  }
};

/// What else of L and the stress in the middle of a step leads to its end: the power σ : L, of which P : Ḟ V_0/m is
/// that over ρ, and the growth of the volume.
template <int D, bool rings>
struct PowerAndGrowth {
  const Symmetric<double, D>* half_deviatoric_stress;
  const double* half_pressure;
  const Tensor<double, D>* velocity_gradient;
  const double* across_rate;  ///< of rings, 1/s
  double* power;              ///< W/m³
  double* growth;             ///< 1/s

  void operator()(std::size_t i) const {
    const auto& l = velocity_gradient[i];
    power[i] = contract(half_deviatoric_stress[i], symmetric_part(l)) - half_pressure[i] * trace(l);
    growth[i] = trace(l);
    if constexpr (rings) {
      power[i] += (half_deviatoric_stress[i].c[2] - half_pressure[i]) * across_rate[i];
      growth[i] += across_rate[i];
    }
  }
};

/// Velocity, place, density and energy at the end of the step.
template <int D>
struct AdvanceLagrangianMotion {
  const ReferenceRecord<D>* reference;
  const MotionRecord<D>* motion;
  const double* half_power;
  const double* growth;
  const double* half_density;
  const Vector<double, D>* acceleration;
  const double* viscous_power;
  double step;
  Vector<double, D>* position;
  Vector<double, D>* velocity;
  double* density;
  double* energy;
  double* viscous_work;

  void operator()(std::size_t i) const {
    velocity[i] = velocity[i] + step * acceleration[i];
    position[i] = motion[i].x + (0.5 * step) * velocity[i];
    density[i] = reference[i].lagrangian != 0.0 ? half_density[i] * std::exp(-0.5 * step * growth[i])
                                                : density[i] * density_factor(step * growth[i]);
    energy[i] += step * (half_power[i] / half_density[i] + viscous_power[i]);
    viscous_work[i] += step * viscous_power[i];
  }
};

}  // namespace tektite
