#pragma once
// What the Godunov schemes add in plane stress: pairs count density, stress and volume per area of the membrane.

#include <cmath>

#include "core/tensor_algebra.hpp"
#include "passes/across.hpp"
#include "passes/godunov_heat.hpp"

namespace tektite {

/// Thickness of the membrane in plane stress; one in every other space.
template <bool plane_stress>
double membrane(const double* thickness, std::size_t i) {
  if constexpr (plane_stress)
    return thickness[i];
  else
    return 1.0;
}

/// Before the stretch across the plane is sought: the area grows as the contacts have it, and what a pair sum makes of
/// the power beyond that of the stress, σ:L, heats as a viscosity would.
struct GrowArea {
  GodunovHeat<2> heat;
  const double* divergence;  ///< tr L* of the contacts, 1/s
  const Symmetric<double, 2>* deviatoric_stress;
  const double* pressure;
  const double* density;
  Tensor<double, 2>* velocity_gradient;  ///< gets the trace tr L*
  double* viscous_power;                 ///< W/kg

  void operator()(std::size_t i) const {
    auto& l = velocity_gradient[i];
    const double missing = 0.5 * (divergence[i] - trace(l));
    for (int k = 0; k < 2; ++k) l(k, k) += missing;
    const double work = contract(deviatoric_stress[i], symmetric_part(l)) - pressure[i] * trace(l);
    viscous_power[i] = heat(i) - work / density[i];
  }
};

}  // namespace tektite
