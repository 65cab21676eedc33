#pragma once

#include <optional>

#include "run/simulation.hpp"

namespace tektite {

/// At the end of a run of several bodies: a warning where no two have met, and none lie so near that they may have been
/// in touch all the time.
std::optional<Warning> no_contact(const Simulation& simulation);

}  // namespace tektite
