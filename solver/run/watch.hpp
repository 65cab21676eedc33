#pragma once
// Looks at the particles of a run for what its scheme cannot tell of itself, so that a failure has a name and no number
// is given in silence.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/particles.hpp"
#include "physics/material.hpp"

namespace tektite {

struct Warning {
  std::string name;
  std::string text;  ///< what was found, what it means, what may mend it
};

/// Of what a lattice of the particle's mass and density has between neighbours: Eulerian particles that are nearer
/// stick to each other. A squeeze that keeps the volume brings them as near at a strain of ln 3 = 1.1.
inline constexpr double clumped_distance = 1.0 / 3.0;

/// Of a body's particles: clumps of fewer are told from a few that are pressed together where bodies meet.
inline constexpr double clumped_share = 0.01;

class Watch {
 public:
  /// What is found now and has not been told yet. Names:
  ///   clumping   Eulerian particles of a body lie in clumps: the tensile instability
  std::vector<Warning> look(const Particles& particles, const std::map<std::string, Material>& materials);

  /// Names of all that has been told.
  const std::set<std::string>& names() const { return names_; }

 private:
  std::set<std::string> names_;
  std::set<std::string> told_;  ///< names with bodies
};

/// The part of a body's particles that have an Eulerian kernel and another such particle of the body nearer than
/// `clumped_distance`. `density` is the body's at rest, in kg/m³.
double clumped_part(const Particles& particles, const Body& body, double density);

}  // namespace tektite
