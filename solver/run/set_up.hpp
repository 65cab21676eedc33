#pragma once
// From a file of particles to a simulation of them: the scene that travels with it, what the solver reads of that, and
// whether both fit together. Of several ranks each has its own particles, and all come to the same.

#include "core/document.hpp"
#include "core/snapshot.hpp"
#include "run/run_settings.hpp"
#include "run/simulation.hpp"

namespace tektite {

Document scene_of(const Snapshot& snapshot, const std::string& file);

/// What the solver reads of the scene; afterwards `document` is the effective one. Throws InputError.
RunSettings settings_of(const Snapshot& snapshot, const std::string& file, Document& document);

/// Throws InputError, with the key's place in the scene, where the scheme refuses what the scene asks for.
Simulation simulation_of(Snapshot snapshot, RunSettings settings, bool resumed, Document& document);

}  // namespace tektite
