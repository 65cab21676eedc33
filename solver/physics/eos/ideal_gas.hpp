#pragma once

#include <array>

#include "physics/model.hpp"

namespace tektite {

/// p = (γ - 1) ρ e: Batra and Zhang (2008), eq. 4.4.
struct IdealGas {
  static constexpr std::string_view name = "ideal-gas";
  double reference_density = 0.0;
  double heat_ratio = 0.0;

  static auto parameters() {
    return std::array{Parameter<IdealGas>{
        "heat_ratio", &IdealGas::heat_ratio, dimension::none, {1.0, 10.0, true}, "ratio of specific heats γ"}};
  }
  double pressure(double rho, double e) const { return (heat_ratio - 1.0) * rho * e; }
  double pressure_by_density(double, double e) const { return (heat_ratio - 1.0) * e; }
  double pressure_by_energy(double rho, double) const { return (heat_ratio - 1.0) * rho; }
};

}  // namespace tektite
