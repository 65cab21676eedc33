#pragma once

#include <variant>

#include "physics/viscosity/monaghan.hpp"

namespace tektite {

/// Artificial viscosities: the dissipative pair term of the schemes that are not Godunov's.
using Viscosity = std::variant<MonaghanViscosity>;

}  // namespace tektite
