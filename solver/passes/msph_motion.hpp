#pragma once
// What MSPH does with the sums, particle by particle; Batra and Zhang (2008), eq. 3.1-3.6 with the limits on the axis.

#include <Eigen/Dense>
#include <cmath>

#include "boundary/anvil.hpp"
#include "passes/across.hpp"
#include "passes/eulerian_record.hpp"

namespace tektite {

/// v += dt/ρ (∂σ_ab/∂x_b + what turning about the axis adds: (σ_RR - σ_θθ)/R along R and σ_RZ/R along Z, of which
/// the limit on the axis is ∂σ_RZ/∂R).
template <int D, int hoops>
struct MsphKick {
  const EulerianRecord<D>* records;
  const Symmetric<double, D>* deviatoric_stress;
  const double* pressure;
  const Vector<double, D>* divergence;
  const double* radial_part;
  const std::uint8_t* held;
  int wall;
  double step;
  Vector<double, D>* velocity;
  Vector<double, D>* acceleration;

  void operator()(std::size_t i) const {
    const auto& r = records[i];
    auto force = divergence[i];
    if constexpr (hoops > 0) {
      const double radius = r.x[0];
      const double across = deviatoric_stress[i].c[D == 1 ? 1 : 2] - pressure[i];
      if (radius > 0.0) force[0] += hoops * (r.stress[0] - across) / radius;
      if constexpr (D == 2)
        force[1] += radius > 0.0 ? r.stress[EulerianRecord<D>::index(0, 1)] / radius : radial_part[i];
    }
    acceleration[i] = (1.0 / r.density) * force;
    if (held[i]) acceleration[i][wall] = 0.0;
    velocity[i] += step * acceleration[i];
    if (held[i]) velocity[i][wall] = 0.0;
  }
};

/// The velocity after smoothing, with what that heats.
template <int D>
struct MsphApplySmoothing {
  const Vector<double, D>* change;
  const double* heat;
  const double* exchange;
  const std::uint8_t* held;
  int wall;
  Vector<double, D>* velocity;
  double* energy;
  double* viscous_work;

  void operator()(std::size_t i) const {
    auto dv = change[i];
    if (held[i]) dv[wall] = 0.0;
    velocity[i] += dv;
    const double heating = heat[i] - 0.5 * dot(dv, dv);
    energy[i] += heating + exchange[i];
    viscous_work[i] += heating;
  }
};

/// Turns the gradient of the velocity over the places at the start of a step into that over the places of its middle,
/// L (1 + L dt/2)⁻¹, exact for linear motions; with it the rate of the ring or shell, U_R/R, of which the limit on the
/// axis is ∂U_R/∂R; and the density's and energy's predictions for the middle.
template <int D, int hoops>
struct MsphMiddle {
  const EulerianRecord<D>* records;
  const Vector<double, D>* fitted;
  const Symmetric<double, D>* deviatoric_stress;
  const double* pressure;
  const double* density;
  const double* energy;
  double step;
  Tensor<double, D>* gradient;
  double* across_rate;
  double* half_density;
  double* half_energy;

  void operator()(std::size_t i) const {
    Eigen::Matrix<double, D, D> l;
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) l(a, b) = gradient[i](a, b);
    const Eigen::Matrix<double, D, D> stretched = Eigen::Matrix<double, D, D>::Identity() + 0.5 * step * l;
    l = l * stretched.inverse();
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) gradient[i](a, b) = l(a, b);
    double hoop = 0.0;
    if constexpr (hoops > 0) {
      const double radius = records[i].x[0], speed = fitted[i][0];
      hoop = radius > 0.0 ? speed / (radius + 0.5 * step * speed) : gradient[i](0, 0);
    }
    across_rate[i] = hoop;
    half_density[i] = density[i] * density_factor(0.5 * step * expansion(i));
    half_energy[i] = energy[i] + 0.5 * step * (deviatoric_power(i) - pressure[i] * expansion(i)) / density[i];
  }

  /// s:D in W/m³, with the deviatoric stress as it is.
  double deviatoric_power(std::size_t i) const {
    double work = contract(deviatoric_stress[i], symmetric_part(gradient[i]));
    if constexpr (hoops == 1) work += across_rate[i] * deviatoric_stress[i].c[D == 1 ? 1 : 2];
    if constexpr (hoops == 2) work += across_rate[i] * (deviatoric_stress[i].c[1] + deviatoric_stress[i].c[2]);
    return work;
  }
  /// tr D in 1/s.
  double expansion(std::size_t i) const { return trace(gradient[i]) + hoops * across_rate[i]; }
};

/// Half of what the deviatoric stress does in a step. Before the stress is advanced and again after it, this is the
/// mean of both over the step, which an elastic wave gives back.
template <int D, int hoops>
struct MsphDeviatoricWork {
  MsphMiddle<D, hoops> middle;
  double* energy;

  void operator()(std::size_t i) const {
    energy[i] += 0.5 * middle.step * middle.deviatoric_power(i) / middle.half_density[i];
  }
};

/// Place, density and energy at the end of a step, with the rates and the pressure of its middle.
template <int D, int hoops>
struct MsphAdvance {
  MsphMiddle<D, hoops> middle;
  const double* half_pressure;
  Anvil<D> anvil;
  Vector<double, D>* position;
  Vector<double, D>* velocity;
  double* density;
  double* energy;

  void operator()(std::size_t i) const {
    const double step = middle.step;
    energy[i] -= step * half_pressure[i] * middle.expansion(i) / middle.half_density[i];
    density[i] *= density_factor(step * middle.expansion(i));
    position[i] += step * middle.fitted[i];
    if (!anvil.touches(position[i])) return;
    anvil.keep_out(position[i]);
    velocity[i][anvil.axis()] = 0.0;
  }
};

}  // namespace tektite
