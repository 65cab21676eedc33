#pragma once

#include <array>

#include "physics/model.hpp"

namespace tektite {

/// Mie-Grüneisen about the Hugoniot u_s = c0 + S1 u_p, with ζ = ρ/ρ0 - 1:
///   p = ρ0 c0² ζ (1 + (1 - Γ0/2) ζ) / (1 - (S1 - 1) ζ)² + ρ0 Γ0 e
/// in compression, which is the time-split Godunov paper's eq. 37 with η = 1 + ζ; in expansion p = ρ0 c0² ζ + ρ0 Γ0 e.
/// Γ0 = 0 gives the Hugoniot form of that paper's flyer plate.
struct MieGrueneisen {
  static constexpr std::string_view name = "mie-grueneisen";
  double reference_density = 0.0;
  double bulk_sound_speed = 0.0;
  double hugoniot_slope = 0.0;
  double grueneisen = 0.0;

  static auto parameters() {
    return std::array{
        Parameter<MieGrueneisen>{"bulk_sound_speed", &MieGrueneisen::bulk_sound_speed, dimension::speed,
                                 limits::positive, "bulk sound speed c0"},
        Parameter<MieGrueneisen>{"hugoniot_slope",
                                 &MieGrueneisen::hugoniot_slope,
                                 dimension::none,
                                 {1.0, 5.0},
                                 "slope S1 of shock speed over particle speed"},
        Parameter<MieGrueneisen>{
            "grueneisen", &MieGrueneisen::grueneisen, dimension::none, {0.0, 10.0}, "Grüneisen parameter Γ0"}};
  }
  double pressure(double rho, double e) const {
    const double zeta = rho / reference_density - 1.0;
    const double stiffness = reference_density * bulk_sound_speed * bulk_sound_speed;
    const double thermal = reference_density * grueneisen * e;
    if (zeta <= 0.0) return stiffness * zeta + thermal;
    const double below = 1.0 - (hugoniot_slope - 1.0) * zeta;
    return stiffness * zeta * (1.0 + (1.0 - 0.5 * grueneisen) * zeta) / (below * below) + thermal;
  }
  double pressure_by_density(double rho, double) const {
    const double zeta = rho / reference_density - 1.0;
    const double c0_squared = bulk_sound_speed * bulk_sound_speed;
    if (zeta <= 0.0) return c0_squared;
    const double a = 1.0 - 0.5 * grueneisen;
    const double b = hugoniot_slope - 1.0;
    const double below = 1.0 - b * zeta;
    return c0_squared * ((1.0 + 2.0 * a * zeta) * below + 2.0 * b * zeta * (1.0 + a * zeta)) / (below * below * below);
  }
  double pressure_by_energy(double, double) const { return reference_density * grueneisen; }
};

}  // namespace tektite
