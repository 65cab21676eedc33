#pragma once
// Impacts that press bodies together by more than their contact bears.

#include <string>
#include <vector>

#include "advice/impact.hpp"
#include "run/run_settings.hpp"

namespace tektite {

/// A line for each impact whose pressure by Hugoniot matching is above the largest that the contact's potential has
/// between flat faces: the bodies run into each other, and what goes through their faces is far too small. Where one is
/// a gas, which has no bulk modulus at rest, the contact bears nothing.
std::vector<std::string> weak_contacts(const Particles& particles, const RunSettings& settings,
                                       const std::vector<Meeting>& meetings);

}  // namespace tektite
