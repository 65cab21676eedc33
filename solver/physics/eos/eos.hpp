#pragma once
// Equations of state p(ρ, e): pressure in Pa from density in kg/m³ and specific internal energy in J/kg, with both
// derivatives, from which the sound speed follows. Compression is positive.

#include <variant>

#include "physics/eos/ideal_gas.hpp"
#include "physics/eos/linear.hpp"
#include "physics/eos/mie_grueneisen.hpp"
#include "physics/eos/mie_grueneisen_cubic.hpp"
#include "physics/eos/mie_grueneisen_isothermal.hpp"
#include "physics/eos/polynomial.hpp"
#include "physics/eos/stiffened_gas.hpp"

namespace tektite {

using Eos = std::variant<LinearEos, PolynomialEos, StiffenedGas, MieGrueneisen, MieGrueneisenCubic,
                         MieGrueneisenIsothermal, IdealGas>;

/// c² = (∂p/∂ρ)_e + p/ρ² (∂p/∂e)_ρ, the isentropic derivative; may be negative outside the range of a model.
template <class Model>
double sound_speed_squared(const Model& eos, double rho, double e) {
  return eos.pressure_by_density(rho, e) + eos.pressure(rho, e) / (rho * rho) * eos.pressure_by_energy(rho, e);
}

}  // namespace tektite
