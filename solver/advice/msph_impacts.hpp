#pragma once

#include <string>
#include <vector>

#include "advice/impact.hpp"
#include "run/run_settings.hpp"

namespace tektite {

/// How far the energy of an impact by msph or ssph comes out wrong: with strong forces, which keep neither momentum nor
/// energy where stresses jump, and with bodies of few particles, where some such runs end in an error.
std::vector<std::string> msph_impacts(const Particles& particles, const RunSettings& settings,
                                      const std::vector<Meeting>& meetings);

}  // namespace tektite
