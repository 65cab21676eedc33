#pragma once
// What happens where bodies meet, from their materials and velocities alone.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/particles.hpp"
#include "physics/hugoniot.hpp"
#include "physics/material.hpp"

namespace tektite {

/// Speed of the longitudinal wave in a material at rest, m/s.
double wave_speed_at_rest(const Material& material);

/// Two bodies that come nearer.
struct Meeting {
  const Body* first = nullptr;
  const Body* second = nullptr;
  double closing_speed = 0.0;     ///< m/s, of the mean velocities
  double gap = 0.0;               ///< between their outermost particles, m
  double arrival = 0.0;           ///< when the boxes about them come within reach of each other, s
  std::optional<Impact> shocked;  ///< nothing where an equation of state has no such shock
};

/// Every two bodies whose mean velocities bring the boxes about them together.
std::vector<Meeting> meetings(const Particles& particles, const std::map<std::string, Material>& materials);

/// A line for every two bodies that come nearer and whose boxes pass each other by all the same.
std::vector<std::string> misses(const Particles& particles);

/// A line where several bodies start out of each other's reach and no two of them come nearer.
std::vector<std::string> strangers(const Particles& particles);

/// By how much a time step is shorter in impacted material than in the same at rest: the ratio of c_l + 0.6 α c behind
/// and before the strongest shock; 1 where nothing meets.
double step_shortening(const std::vector<Meeting>& meetings, const std::map<std::string, Material>& materials,
                       double alpha);

/// Pressures of the meetings before `end`, in s, a line each; and a line for all that come behind it.
std::vector<std::string> in_words(const std::vector<Meeting>& meetings, double end);

/// Where the strongest of these shocks leaves a body out of the range of its equation of state or flow law.
std::vector<std::string> out_of_range(const std::vector<Meeting>& meetings,
                                      const std::map<std::string, Material>& materials, double end);

}  // namespace tektite
