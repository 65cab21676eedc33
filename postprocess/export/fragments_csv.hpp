#pragma once
// The list of fragments, for those who count debris.

#include <string>

#include "postprocess/measure/connectivity.hpp"

namespace tektite {

/// One line a fragment: its body, number of particles, mass, and place and velocity of its centre of mass, in SI; body
/// after body, the heaviest first. Throws RunError.
void write_fragments(const Whole& whole, const Fragments& fragments, const std::string& path);

}  // namespace tektite
