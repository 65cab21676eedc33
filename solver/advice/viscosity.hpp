#pragma once
// What the artificial viscosity does to material that flows.

#include <string>
#include <vector>

#include "advice/impact.hpp"
#include "run/run_settings.hpp"

namespace tektite {

/// Linear artificial viscosity is a shear viscosity η = α ρ c h/8 in the plane and α ρ c h/10 in space (Monaghan 2005,
/// Rep. Prog. Phys. 68, section 8.1), so material that flows at the rate ε̇ bears 3 η ε̇ beside its flow stress. A line
/// for each body of a meeting, or that flies at the anvil, where that is more than the flow stress; ε̇ is the closing
/// speed over the thickness of the thinner body.
std::vector<std::string> viscous_strengths(const Particles& particles, const RunSettings& settings,
                                           const std::vector<Meeting>& meetings);

}  // namespace tektite
