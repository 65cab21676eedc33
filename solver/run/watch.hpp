#pragma once
// Looks at the particles of a run for what its scheme cannot tell of itself, so that a failure has a name and no number
// is given in silence.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/particles.hpp"
#include "run/run_settings.hpp"

namespace tektite {

/// Of a body's particles: fewer that are too near are told from a few that are pressed together where bodies meet.
inline constexpr double too_near_share = 0.01;

/// Of a body's energy (hourglass_share.hpp).
inline constexpr double notable_hourglass = 0.2;

/// Of a body's particles, those whose density does not fit their places: a shock front and what crosses it are fewer.
inline constexpr double misfit_share = 0.05;

/// Of a gas, particles out of each other's support: an edge loses some ten of them at any spacing.
inline constexpr double untouched_share = 0.001;

/// Of the specific energy of a gas, at a wall over away from it.
inline constexpr double notable_heat = 1.2;

/// Of a body's kinetic energy in its own frame, how much its internal energy lies below zero: none of it is there where
/// a scheme is right to its order.
inline constexpr double notable_debt = 0.05;

class Watch {
 public:
  Watch() = default;
  /// Of a run that is resumed: `state` is what save() put there, so that what was told before is known.
  explicit Watch(const std::map<std::string, double>& state);
  void save(std::map<std::string, double>& state) const;

  /// What is found now, or known by the scheme, and has not been told yet. Names of what is found:
  ///   clumping          Eulerian particles of a body that is no gas lie in clumps: the tensile instability
  ///   interpenetration  bodies, or parts of a total-Lagrangian one, have run into each other or through a plane
  ///   hourglass         total-Lagrangian particles move as their kernels do not see: zero-energy modes, slip
  ///   density-misfit    densities of Eulerian particles have run away from the places of these
  ///   lost-neighbours   a gas has expanded until its particles are out of each other's support
  ///   wall-heating      a gas is hotter at a wall than shocks make it
  ///   energy-debt       a body's internal energy is below zero: its motion has grown out of nothing
  ///   locking           a body is nearly incompressible: it bends too stiffly
  std::vector<Warning> look(const Particles& particles, const RunSettings& settings,
                            const std::vector<Warning>& of_scheme);

  /// Names of all that has been told.
  std::set<std::string> names() const;

 private:
  /// Those of these that have not been told yet.
  std::vector<Warning> note(const std::vector<Warning>& warnings);
  void look_at(const Particles& particles, const Body& body, const RunSettings& settings, std::vector<Warning>& found);
  /// Adds it where it has not been told of this body yet.
  void tell(std::vector<Warning>& found, const std::string& name, const std::string& body, std::string text);
  std::set<std::string> told_;  ///< NAME, or NAME.BODY
};

}  // namespace tektite
