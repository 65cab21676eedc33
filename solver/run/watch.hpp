#pragma once
// Looks at the particles of a run for what its scheme cannot tell of itself, so that a failure has a name and no number
// is given in silence.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/particles.hpp"
#include "physics/material.hpp"
#include "schemes/scheme.hpp"

namespace tektite {

/// Of a body's particles: fewer that are too near are told from a few that are pressed together where bodies meet.
inline constexpr double too_near_share = 0.01;

/// Of a body's energy (hourglass_share.hpp).
inline constexpr double notable_hourglass = 0.2;

class Watch {
 public:
  /// What is found now, or known by the scheme, and has not been told yet. Names of what is found:
  ///   clumping          Eulerian particles of a body lie in clumps: the tensile instability
  ///   interpenetration  bodies, or parts of a total-Lagrangian one, have run into each other
  ///   hourglass         total-Lagrangian particles move as their kernels do not see: zero-energy modes, slip
  std::vector<Warning> look(const Particles& particles, const std::map<std::string, Material>& materials,
                            const std::vector<Warning>& of_scheme);

  /// Names of all that has been told.
  const std::set<std::string>& names() const { return names_; }

 private:
  /// Whether it has not been told of this body yet.
  bool is_new(const std::string& name, const std::string& body);

  std::set<std::string> names_;
  std::set<std::string> told_;  ///< names with bodies
};

}  // namespace tektite
