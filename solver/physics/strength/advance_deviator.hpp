#pragma once
// One step of the deviatoric stress: Jaumann rate, elastic trial, radial return (Wilkins 1964). The spin turns the
// stress by Cayley's orthogonal matrix (Hughes and Winget 1980), so a rigid rotation leaves its invariants as they are
// to round-off however large the step. All of it for one particle or for several side by side (N, core/pack.hpp), each
// of which gets the same bits whatever the others are.

#include <algorithm>
#include <cmath>

#include "core/tensor.hpp"
#include "physics/elementary.hpp"
#include "physics/strength/flow.hpp"

namespace tektite {

template <int D, class N = double>
struct DeviatorState {
  Symmetric<N, D> stress;  ///< s in Pa
  N plastic_strain = 0.0;
  N plastic_work = 0.0;  ///< J/kg
  N temperature = 0.0;   ///< K
  N pressure = 0.0;      ///< Pa, of models that crush
  N damage = 0.0;        ///< of models that crush
};

/// R s Rᵀ for the rotation that the spin W = (L - Lᵀ)/2 makes in dt.
template <int D, class N>
Symmetric<N, D> rotated(const Symmetric<N, D>& s, const Tensor<N, D>& l, double dt) {
  if constexpr (D == 1) {
    return s;
  } else if constexpr (D == 2) {
    const N tangent = 0.25 * dt * (l(1, 0) - l(0, 1));  // of half the angle
    const N f = 1.0 / (1.0 + tangent * tangent);
    const N cosine = (1.0 - tangent * tangent) * f, sine = 2.0 * tangent * f;
    const N mean = 0.5 * (s(0, 0) + s(1, 1)), half = 0.5 * (s(0, 0) - s(1, 1));
    const N cosine2 = cosine * cosine - sine * sine, sine2 = 2.0 * sine * cosine;
    auto turned = s;
    turned(0, 0) = mean + half * cosine2 - s(0, 1) * sine2;
    turned(1, 1) = mean - half * cosine2 + s(0, 1) * sine2;
    turned(0, 1) = half * sine2 + s(0, 1) * cosine2;
    return turned;
  } else {
    // a = ω dt/2 with the axial vector ω of W; R = I + 2/(1 + a·a) ([a]× + [a]×²)
    const N a[3] = {0.25 * dt * (l(2, 1) - l(1, 2)), 0.25 * dt * (l(0, 2) - l(2, 0)), 0.25 * dt * (l(1, 0) - l(0, 1))};
    const N square = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
    const N f = 2.0 / (1.0 + square);
    N r[D][D];
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) r[i][j] = f * a[i] * a[j] + (i == j ? N(1.0 - f * square) : N(0.0));
    const auto add_cross = [&](int i, int j, const N& component) {
      r[i][j] -= f * component;
      r[j][i] += f * component;
    };
    add_cross(0, 1, a[2]);
    add_cross(1, 2, a[0]);
    add_cross(2, 0, a[1]);
    auto turned = s;
    for (int i = 0; i < D; ++i)
      for (int j = i; j < D; ++j) {
        N sum = 0.0;
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
/// the logarithm of the rate is a straight line, within a bracket that it must not leave. Zero where nothing flows.
template <class Model, class N>
N plastic_increment(const Model& model, const N& trial, const N& yield, const FlowState<N>& before, double dt) {
  using std::sqrt, std::abs, std::experimental::any_of;
  const double stiffness = 3.0 * model.shear_modulus;
  const auto flows = trial > yield;
  N increment = select(flows, N((trial - yield) / stiffness), N(1.0));  // 1: any number that can be computed with
  if constexpr (Model::kind.hardens) {
    constexpr int most = 60;
    constexpr double farthest = 5.0;  // steps of ln Δε
    N low = 0.0, high = increment;
    auto open = flows;
    const auto flow = model.flow_in(dt, before);
    for (int k = 0; k < most; ++k) {
      const auto [stress, slope] = flow(increment);
      const N excess = trial - stiffness * increment - stress;
      open = open && abs(excess) > 1e-12 * trial;
      if (!any_of(open)) break;
      low = select(excess > 0.0, increment, low);
      high = select(excess > 0.0, high, increment);
      const N change = smaller(larger(N(excess / ((stiffness + slope) * increment)), N(-farthest)), N(farthest));
      const N next = increment * exponential(change);
      const N halfway = select(low > 0.0, N(sqrt(low * high)), N(0.1 * high));
      increment = select(open, select(next > low && next < high, next, halfway), increment);
    }
  }
  return select(flows, increment, N(0.0));
}

/// Brings s, plastic strain, plastic work and temperature from t to t + dt under the velocity gradient L of the middle
/// of the step; `across` is the rate of deformation normal to a plane of plane stress (zero elsewhere).
template <class Model, int D, class N>
void advance_deviator(const Model& model, const Tensor<N, D>& l, const N& across, const N& density, double dt,
                      DeviatorState<D, N>& state) {
  if constexpr (Model::kind.shears) {
    auto rate = symmetric_part(l);
    if constexpr (D == 2) rate.c[2] = across;
    auto trial = rotated(state.stress, l, dt) + N(2.0 * model.shear_modulus * dt) * deviator(rate);
    if constexpr (Model::kind.yields) {
      const N equivalent = von_mises(trial);
      const FlowState<N> flow{state.plastic_strain, 0.0, state.temperature, state.pressure, state.damage};
      const N yield = model.flow_stress(flow);
      const auto flows = equivalent > yield;
      if (std::experimental::any_of(flows)) {
        const N increment = plastic_increment(model, equivalent, yield, flow, dt);
        // Molten material: the root's rounding must not turn a strength of zero into one below.
        const N strength = larger(N(0.0), N(equivalent - 3.0 * model.shear_modulus * increment));
        trial = select(flows, N(strength / select(flows, equivalent, N(1.0))), N(1.0)) * trial;
        const N work = strength * increment / density;
        state.plastic_strain += increment;
        state.plastic_work += work;
        if constexpr (Model::kind.heats) state.temperature += model.taylor_quinney * work / model.specific_heat;
      }
    }
    state.stress = trial;
  }
}

}  // namespace tektite
