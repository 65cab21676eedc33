#pragma once
// Riemann solvers: what two states that meet agree on. The dissipation of the Godunov schemes comes from them alone.

#include <variant>

#include "physics/riemann/acoustic.hpp"
#include "physics/riemann/exact.hpp"
#include "physics/riemann/two_shock.hpp"

namespace tektite {

using Riemann = std::variant<AcousticRiemann, TwoShockRiemann, ExactRiemann>;

}  // namespace tektite
