#include "front/stages_of_a_run.hpp"

#include <filesystem>

#include "core/program.hpp"

namespace tektite::front {

int check_scene(Stage stage, const SceneArguments& scene) {
  auto words = scene.words();
  words.push_back("--check");
  return run_stage(stage, words);
}

int make_particles(const SceneArguments& scene, const std::string& path, Show show) {
  auto words = scene.words();
  words.insert(words.end(), {"-o", path});
  return run_stage(Stage::preprocess, words, show);
}

int solve_and_show(const std::string& folder, const RunLock& lock, const Words& solver_options,
                   const Words& showing_options) {
  Words solving{folder, "--lock", std::to_string(lock.file())};
  solving.insert(solving.end(), solver_options.begin(), solver_options.end());
  if (const int code = run_stage(Stage::solve, solving); code != exit_done) return code;
  Words showing{folder};
  const auto reference = std::filesystem::path(folder) / reference_name;
  if (std::filesystem::exists(reference)) showing.insert(showing.end(), {"--reference", reference.string()});
  showing.insert(showing.end(), showing_options.begin(), showing_options.end());
  return run_stage(Stage::postprocess, showing);
}

}  // namespace tektite::front
