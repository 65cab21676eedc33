#pragma once
// What no solid or liquid has: a wrong unit, most often.

#include <map>
#include <string>
#include <vector>

#include "physics/material.hpp"

namespace tektite {

/// A line for every material that is denser than osmium, and for every one in which waves are faster than in diamond.
std::vector<std::string> implausible(const std::map<std::string, Material>& materials);

}  // namespace tektite
