#pragma once
// One step of the deviatoric stress: Jaumann rate, elastic trial, radial return (Wilkins 1964). The spin turns the
// stress by Cayley's orthogonal matrix (Hughes and Winget 1980), so a rigid rotation leaves its invariants as they are
// to round-off however large the step.

#include <algorithm>
#include <cmath>

#include "core/tensor.hpp"
#include "physics/strength/flow.hpp"

namespace tektite {

template <int D>
struct DeviatorState {
  Symmetric<double, D> stress;  ///< s in Pa
  double plastic_strain = 0.0;
  double plastic_work = 0.0;  ///< J/kg
  double temperature = 0.0;   ///< K
  double pressure = 0.0;      ///< Pa, of models that crush
  double damage = 0.0;        ///< of models that crush
};

/// R s Rᵀ for the rotation that the spin W = (L - Lᵀ)/2 makes in dt.
template <int D>
Symmetric<double, D> rotated(const Symmetric<double, D>& s, const Tensor<double, D>& l, double dt) {
  if constexpr (D == 1) {
    return s;
  } else if constexpr (D == 2) {
    const double tangent = 0.25 * dt * (l(1, 0) - l(0, 1));  // of half the angle
    const double f = 1.0 / (1.0 + tangent * tangent);
    const double cosine = (1.0 - tangent * tangent) * f, sine = 2.0 * tangent * f;
    const double mean = 0.5 * (s(0, 0) + s(1, 1)), half = 0.5 * (s(0, 0) - s(1, 1));
    const double cosine2 = cosine * cosine - sine * sine, sine2 = 2.0 * sine * cosine;
    auto turned = s;
    turned(0, 0) = mean + half * cosine2 - s(0, 1) * sine2;
    turned(1, 1) = mean - half * cosine2 + s(0, 1) * sine2;
    turned(0, 1) = half * sine2 + s(0, 1) * cosine2;
    return turned;
  } else {
    // a = ω dt/2 with the axial vector ω of W; R = I + 2/(1 + a·a) ([a]× + [a]×²)
    const double a[3] = {0.25 * dt * (l(2, 1) - l(1, 2)), 0.25 * dt * (l(0, 2) - l(2, 0)),
                         0.25 * dt * (l(1, 0) - l(0, 1))};
    const double square = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
    const double f = 2.0 / (1.0 + square);
    double r[D][D];
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) r[i][j] = f * a[i] * a[j] + (i == j ? 1.0 - f * square : 0.0);
    const auto add_cross = [&](int i, int j, double component) {
      r[i][j] -= f * component;
      r[j][i] += f * component;
    };
    add_cross(0, 1, a[2]);
    add_cross(1, 2, a[0]);
    add_cross(2, 0, a[1]);
    auto turned = s;
    for (int i = 0; i < D; ++i)
      for (int j = i; j < D; ++j) {
        double sum = 0.0;
        for (int k = 0; k < D; ++k)
          for (int m = 0; m < D; ++m) sum += r[i][k] * s(k, m) * r[j][m];
        turned(i, j) = sum;
      }
    return turned;
  }
}

/// Plastic strain of a step whose elastic trial has the equivalent stress `trial` above the flow stress: solves
/// trial - 3 G Δε = Y(ε_p + Δε, Δε/dt, T) to 1e-12 of the trial stress; `yield` is Y where nothing flows. The left side
/// falls and the right side does not, so the root is unique. Newton in ln Δε, in which a flow stress that grows with
/// the logarithm of the rate is a straight line, within a bracket that it must not leave.
template <class Model>
double plastic_increment(const Model& model, double trial, double yield, const FlowState& before, double dt) {
  const double stiffness = 3.0 * model.shear_modulus;
  double increment = (trial - yield) / stiffness;
  if constexpr (Model::kind.hardens) {
    constexpr int most = 60;
    constexpr double farthest = 5.0;  // steps of ln Δε
    double low = 0.0, high = increment;
    const auto flow = model.flow_in(dt, before);
    for (int k = 0; k < most; ++k) {
      const auto [stress, slope] = flow(increment);
      const double excess = trial - stiffness * increment - stress;
      if (std::abs(excess) <= 1e-12 * trial) break;
      (excess > 0.0 ? low : high) = increment;
      increment *= std::exp(std::clamp(excess / ((stiffness + slope) * increment), -farthest, farthest));
      if (!(increment > low && increment < high)) increment = low > 0.0 ? std::sqrt(low * high) : 0.1 * high;
    }
  }
  return increment;
}

/// Brings s, plastic strain, plastic work and temperature from t to t + dt under the velocity gradient L of the middle
/// of the step; `across` is the rate of deformation normal to a plane of plane stress (zero elsewhere).
template <class Model, int D>
void advance_deviator(const Model& model, const Tensor<double, D>& l, double across, double density, double dt,
                      DeviatorState<D>& state) {
  if constexpr (Model::kind.shears) {
    auto rate = symmetric_part(l);
    if constexpr (D == 2) rate.c[2] = across;
    auto trial = rotated(state.stress, l, dt) + (2.0 * model.shear_modulus * dt) * deviator(rate);
    if constexpr (Model::kind.yields) {
      const double equivalent = von_mises(trial);
      const FlowState flow{state.plastic_strain, 0.0, state.temperature, state.pressure, state.damage};
      const double yield = model.flow_stress(flow);
      if (equivalent > yield) {
        const double increment = plastic_increment(model, equivalent, yield, flow, dt);
        // Molten material: the root's rounding must not turn a strength of zero into one below.
        const double strength = std::max(0.0, equivalent - 3.0 * model.shear_modulus * increment);
        trial = (strength / equivalent) * trial;
        const double work = strength * increment / density;
        state.plastic_strain += increment;
        state.plastic_work += work;
        if constexpr (Model::kind.heats) state.temperature += model.taylor_quinney * work / model.specific_heat;
      }
    }
    state.stress = trial;
  }
}

}  // namespace tektite
