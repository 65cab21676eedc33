#pragma once

#include <array>

#include "physics/model.hpp"

namespace tektite {

/// p = K (ρ/ρ0 - 1): Batra and Zhang (2008), eq. 3.17.
struct LinearEos {
  static constexpr std::string_view name = "linear";
  double reference_density = 0.0;
  double bulk_modulus = 0.0;

  static auto parameters() {
    return std::array{Parameter<LinearEos>{"bulk_modulus", &LinearEos::bulk_modulus, dimension::pressure,
                                           limits::positive, "bulk modulus K"}};
  }
  double pressure(double rho, double) const { return bulk_modulus * (rho / reference_density - 1.0); }
  double pressure_by_density(double, double) const { return bulk_modulus / reference_density; }
  double pressure_by_energy(double, double) const { return 0.0; }
};

}  // namespace tektite
