#pragma once
// What contacts cost elastic bodies: impacts that are too slow for one that begins where kernels meet, and faces whose
// particles shove each other aside.

#include <string>
#include <vector>

#include "advice/impact.hpp"
#include "run/run_settings.hpp"

namespace tektite {

/// Such a contact yields over the way from where kernels meet to where faces touch. A line for each elastic impact that
/// takes longer for that than waves take through the shorter body and back: they have gone to and fro before the
/// contact bears anything, and the bodies part late and as rigid ones do. Elastic is what the acoustic stress, of Z_a
/// Z_b/(Z_a + Z_b) times the closing speed, does not make flow.
std::vector<std::string> slow_contacts(const Particles& particles, const RunSettings& settings,
                                       const std::vector<Meeting>& meetings);

/// A line for each elastic impact of total-Lagrangian bodies whose zero-energy modes are not controlled: by these the
/// particles of faces in contact move aside, and the viscosity takes their motion.
std::vector<std::string> rough_contacts(const Particles& particles, const RunSettings& settings,
                                        const std::vector<Meeting>& meetings);

}  // namespace tektite
