#pragma once
// What no solid or liquid has, and no run lasts: a wrong unit, most often.

#include <map>
#include <string>
#include <vector>

#include "core/particles.hpp"
#include "physics/material.hpp"
#include "run/run_settings.hpp"

namespace tektite {

/// A line for every material that is denser than osmium, and for every one in which waves are faster than in diamond.
std::vector<std::string> implausible(const std::map<std::string, Material>& materials);

/// A line where the end comes later than anybody would compute: after a hundred thousand times what the slowest waves
/// take through everything. Bars that ring for a million steps do so for a few thousand times, bodies that fly at 1 m/s
/// over twice their distance for ten thousand times.
std::vector<std::string> implausible_end(const Particles& particles, const RunSettings& settings);

}  // namespace tektite
