#pragma once
// The steps of which run, check and resume consist. Each gives the exit code of the stage that failed, which has told
// its fault, or exit_done.

#include <string>

#include "core/run_lock.hpp"
#include "front/scene_arguments.hpp"
#include "front/stage.hpp"

namespace tektite::front {

/// The published values as a run keeps them, so that it can be shown again wherever it is moved.
inline constexpr const char* reference_name = "reference.toml";

/// Has a stage that reads the scene file validate its part and say in words what it would do.
int check_scene(Stage stage, const SceneArguments& scene);

/// Writes the initial particles, which validates everything that they depend on.
int make_particles(const SceneArguments& scene, const std::string& path, Show show = Show::output);

/// Solves the run in `folder`, which is locked, measures and draws it, and sets it beside what was published.
int solve_and_show(const std::string& folder, const RunLock& lock, const Words& solver_options,
                   const Words& showing_options = {});

}  // namespace tektite::front
