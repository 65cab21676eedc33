#pragma once

#include <variant>

#include "physics/viscosity/limited.hpp"
#include "physics/viscosity/monaghan.hpp"

namespace tektite {

/// Artificial viscosities: the dissipative pair term of the schemes that are not Godunov's.
using Viscosity = std::variant<MonaghanViscosity, LimitedViscosity>;

/// α and β, which every one has.
inline const MonaghanPair& coefficients_of(const Viscosity& viscosity) {
  return std::visit([](const MonaghanPair& any) -> const MonaghanPair& { return any; }, viscosity);
}

/// Whether it reads the particles' velocity gradients.
inline bool reconstructs(const Viscosity& viscosity) {
  return std::visit([](const auto& any) { return any.reconstructs; }, viscosity);
}

}  // namespace tektite
