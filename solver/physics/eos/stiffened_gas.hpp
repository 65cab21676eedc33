#pragma once

#include <array>

#include "physics/model.hpp"

namespace tektite {

/// p = c0² (ρ - ρ0) + (γ0 - 1) ρ e: Young et al. (2021), eq. 17.
struct StiffenedGas {
  static constexpr std::string_view name = "stiffened-gas";
  double reference_density = 0.0;
  double bulk_sound_speed = 0.0;
  double grueneisen = 0.0;

  static auto parameters() {
    return std::array{
        Parameter<StiffenedGas>{"bulk_sound_speed", &StiffenedGas::bulk_sound_speed, dimension::speed, limits::positive,
                                "bulk sound speed c0"},
        Parameter<StiffenedGas>{
            "grueneisen", &StiffenedGas::grueneisen, dimension::none, {1.0, 10.0}, "Grüneisen parameter γ0"}};
  }
  double pressure(double rho, double e) const {
    const double c0 = bulk_sound_speed;
    return c0 * c0 * (rho - reference_density) + (grueneisen - 1.0) * rho * e;
  }
  double pressure_by_density(double, double e) const {
    return bulk_sound_speed * bulk_sound_speed + (grueneisen - 1.0) * e;
  }
  double pressure_by_energy(double rho, double) const { return (grueneisen - 1.0) * rho; }
};

}  // namespace tektite
