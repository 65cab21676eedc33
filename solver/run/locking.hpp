#pragma once
// Elasticity so near to incompressible that bending locks.

#include <optional>
#include <string>

#include "physics/material.hpp"

namespace tektite {

/// Of Poisson's ratio: bending is too stiff by 3 % and more from here on (docs/stability.md).
inline constexpr double locking_ratio = 0.489;

/// What a user is told of a body of this material; nothing where it does not lock or has no resistance to shear.
std::optional<std::string> locking(const std::string& body, const Material& material);

}  // namespace tektite
