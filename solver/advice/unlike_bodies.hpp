#pragma once

#include <string>
#include <vector>

#include "advice/impact.hpp"
#include "run/run_settings.hpp"

namespace tektite {

/// A line for every two bodies that meet by Eulerian kernel sums without a contact, where steps that are short enough
/// for the waves of each are too long for light particles between stiff ones: the stress of a stiff neighbour changes
/// by its modulus and moves the mass of a light one.
std::vector<std::string> unlike_bodies(const Particles& particles, const RunSettings& settings,
                                       const std::vector<Meeting>& meetings);

}  // namespace tektite
