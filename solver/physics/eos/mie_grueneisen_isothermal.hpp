#pragma once

#include <array>

#include "physics/model.hpp"

namespace tektite {

/// p = ρ0 c0² ζ / (1 - (S1 - 1) ζ) with ζ = ρ/ρ0 - 1, as eq. 36 of the time-split Godunov paper prints it: it agrees
/// with the Hugoniot form (mie-grueneisen with Γ0 = 0) to first order in ζ only.
struct MieGrueneisenIsothermal {
  static constexpr std::string_view name = "mie-grueneisen-isothermal";
  double reference_density = 0.0;
  double bulk_sound_speed = 0.0;
  double hugoniot_slope = 0.0;

  static auto parameters() {
    return std::array{Parameter<MieGrueneisenIsothermal>{"bulk_sound_speed", &MieGrueneisenIsothermal::bulk_sound_speed,
                                                         dimension::speed, limits::positive, "bulk sound speed c0"},
                      Parameter<MieGrueneisenIsothermal>{"hugoniot_slope",
                                                         &MieGrueneisenIsothermal::hugoniot_slope,
                                                         dimension::none,
                                                         {1.0, 5.0},
                                                         "slope S1 of shock speed over particle speed"}};
  }
  double pressure(double rho, double) const {
    const double zeta = rho / reference_density - 1.0;
    return reference_density * bulk_sound_speed * bulk_sound_speed * zeta / (1.0 - (hugoniot_slope - 1.0) * zeta);
  }
  double pressure_by_density(double rho, double) const {
    const double below = 1.0 - (hugoniot_slope - 1.0) * (rho / reference_density - 1.0);
    return bulk_sound_speed * bulk_sound_speed / (below * below);
  }
  double pressure_by_energy(double, double) const { return 0.0; }
};

}  // namespace tektite
