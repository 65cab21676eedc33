#pragma once

#include <array>

#include "physics/model.hpp"

namespace tektite {

/// p = k1 ζ + k2 ζ² + k3 ζ³ with ζ = ρ/ρ0 - 1; in expansion p = k1 ζ, because the higher terms belong to the
/// compression curve and would turn p back down. Connolly and Iannucci's time-split Godunov paper, eq. 39.
struct PolynomialEos {
  static constexpr std::string_view name = "polynomial";
  double reference_density = 0.0;
  double k1 = 0.0;
  double k2 = 0.0;
  double k3 = 0.0;

  static auto parameters() {
    return std::array{
        Parameter<PolynomialEos>{"k1", &PolynomialEos::k1, dimension::pressure, limits::positive, "bulk modulus"},
        Parameter<PolynomialEos>{"k2", &PolynomialEos::k2, dimension::pressure, limits::any, "second coefficient", 0.0},
        Parameter<PolynomialEos>{"k3", &PolynomialEos::k3, dimension::pressure, limits::any, "third coefficient", 0.0}};
  }
  double pressure(double rho, double) const {
    const double zeta = rho / reference_density - 1.0;
    return zeta > 0.0 ? zeta * (k1 + zeta * (k2 + zeta * k3)) : k1 * zeta;
  }
  double pressure_by_density(double rho, double) const {
    const double zeta = rho / reference_density - 1.0;
    return (zeta > 0.0 ? k1 + zeta * (2.0 * k2 + 3.0 * zeta * k3) : k1) / reference_density;
  }
  double pressure_by_energy(double, double) const { return 0.0; }
};

}  // namespace tektite
