#pragma once

#include <set>
#include <string>

#include "run/simulation.hpp"
#include "run/watch.hpp"

namespace tektite::test {

/// Names of what a run has to say of itself in its present state.
inline std::set<std::string> said(const Simulation& simulation) {
  Watch watch;
  watch.look(simulation.particles(), simulation.settings(), simulation.scheme().warnings());
  return watch.names();
}

}  // namespace tektite::test
