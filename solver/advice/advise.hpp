#pragma once
// What `tektite check` says of a scene beside whether it is right: what it could save, and what to doubt.

#include <string>
#include <vector>

#include "advice/impact.hpp"
#include "run/run_settings.hpp"

namespace tektite {

struct Advice {
  std::vector<std::string> lines;     ///< in plain words
  std::vector<std::string> settings;  ///< KEY=VALUE that make the reduced scene; empty where there is nothing to save
};

/// From the particles of the scene at time 0 and from the scene itself.
Advice advise(const Particles& particles, const RunSettings& settings, const std::vector<Meeting>& meetings,
              Document& document);

}  // namespace tektite
