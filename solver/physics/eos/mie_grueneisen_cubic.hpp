#pragma once

#include <array>

#include "physics/model.hpp"

namespace tektite {

/// Mie-Grüneisen with a cubic Hugoniot u_s = c0 + S1 u_p + S2 u_p²/u_s + S3 u_p³/u_s² and a volume correction a of γ0,
/// as in LS-DYNA's *EOS_GRUNEISEN and Young et al. (2021), section 3.3, with μ = ρ/ρ0 - 1 and E = ρ0 e:
///   p = ρ0 c0² μ (1 + (1 - γ0/2) μ - a/2 μ²) / (1 - (S1 - 1) μ - S2 μ²/(μ + 1) - S3 μ³/(μ + 1)²)² + (γ0 + a μ) E
/// in compression; p = ρ0 c0² μ + (γ0 + a μ) E in expansion.
struct MieGrueneisenCubic {
  static constexpr std::string_view name = "mie-grueneisen-cubic";
  double reference_density = 0.0;
  double bulk_sound_speed = 0.0;
  double s1 = 0.0;
  double s2 = 0.0;
  double s3 = 0.0;
  double grueneisen = 0.0;
  double a = 0.0;

  static auto parameters() {
    using M = MieGrueneisenCubic;
    return std::array{
        Parameter<M>{"bulk_sound_speed", &M::bulk_sound_speed, dimension::speed, limits::positive,
                     "bulk sound speed c0"},
        Parameter<M>{"s1", &M::s1, dimension::none, {0.0, 5.0}, "first slope S1"},
        Parameter<M>{"s2", &M::s2, dimension::none, {-5.0, 5.0}, "second slope S2", 0.0},
        Parameter<M>{"s3", &M::s3, dimension::none, {-5.0, 5.0}, "third slope S3", 0.0},
        Parameter<M>{"grueneisen", &M::grueneisen, dimension::none, {0.0, 10.0}, "Grüneisen parameter γ0"},
        Parameter<M>{"volume_correction", &M::a, dimension::none, {0.0, 10.0}, "first-order correction a of γ0", 0.0}};
  }
  double pressure(double rho, double e) const {
    const double mu = rho / reference_density - 1.0;
    const double stiffness = reference_density * bulk_sound_speed * bulk_sound_speed;
    const double thermal = (grueneisen + a * mu) * reference_density * e;
    if (mu <= 0.0) return stiffness * mu + thermal;
    const double below = denominator(mu);
    return stiffness * numerator(mu) / (below * below) + thermal;
  }
  double pressure_by_density(double rho, double e) const {
    const double mu = rho / reference_density - 1.0;
    const double c0_squared = bulk_sound_speed * bulk_sound_speed;
    if (mu <= 0.0) return c0_squared + a * e;
    const double below = denominator(mu);
    const double n_slope = 1.0 + 2.0 * (1.0 - 0.5 * grueneisen) * mu - 1.5 * a * mu * mu;
    const double x = mu / (mu + 1.0);
    const double below_slope = -(s1 - 1.0) - s2 * x * (2.0 - x) - s3 * x * x * (3.0 - 2.0 * x);
    return c0_squared * (n_slope * below - 2.0 * numerator(mu) * below_slope) / (below * below * below) + a * e;
  }
  double pressure_by_energy(double rho, double) const {
    return (grueneisen + a * (rho / reference_density - 1.0)) * reference_density;
  }

 private:
  double numerator(double mu) const { return mu * (1.0 + (1.0 - 0.5 * grueneisen) * mu - 0.5 * a * mu * mu); }
  double denominator(double mu) const {
    const double x = mu / (mu + 1.0);
    return 1.0 - (s1 - 1.0) * mu - s2 * mu * x - s3 * mu * x * x;
  }
};

}  // namespace tektite
