#pragma once

#include <optional>

#include "run/simulation.hpp"

namespace tektite {

/// Bodies that start within each other's reach: what the contact between them holds before the first step is set free
/// and drives them apart. Nothing where that is less than a thousandth of the kinetic energy.
std::optional<Warning> contact_at_start(const Simulation& simulation);

}  // namespace tektite
