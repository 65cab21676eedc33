// tektite check: every stage validates its part of the scene and says in words what it would do.

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "core/system_words.hpp"
#include "core/write_beside.hpp"
#include "front/commands.hpp"
#include "front/scene_arguments.hpp"
#include "front/stages_of_a_run.hpp"

namespace tektite::front {
namespace {

/// A folder that is removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::error_code fault;
    auto name = (std::filesystem::temp_directory_path(fault) / "tektite-check-XXXXXX").string();
    if (fault) throw RunError("TMPDIR: there is no folder for what is checked: " + fault.message());
    if (!::mkdtemp(name.data())) throw RunError(name + ": this folder cannot be made: " + words_for_error(errno));
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& file) { return fs::weakly_canonical(fs::absolute(file)).parent_path(); }

/// Throws InputError where the reduced scene cannot be written there.
void check_target(const fs::path& target, const fs::path& scene) {
  if (fs::exists(target)) throw InputError({{target.string(), 0}, {}, {}, "is there already", "a new name"});
  if (folder_of(target) != folder_of(scene))
    throw InputError({{target.string(), 0},
                      {},
                      {},
                      "paths in a scene are relative to its folder, which this is not",
                      "a name in the folder of the scene"});
}

/// The scene with the settings of `advice`, a line each, laid over it. Nothing is written where there are none.
void write_reduced(SceneArguments scene, const std::string& advice, const std::string& target) {
  std::ifstream lines(advice);
  bool reduced = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    scene.settings.push_back(line);
    reduced = true;
  }
  if (!reduced) {
    fmt::print("nothing to save is known: {} is not written\n", target);
    return;
  }
  const auto text = scene.load().text();
  write_text_beside(target, text.substr(0, text.find("\n#@ ") + 1));  // what follows tells of the lines of this scene
  fmt::print("the reduced scene is written to {}\n", target);
}

}  // namespace

int check(const Words& arguments) {
  SceneArguments scene;
  std::string target;
  CommandLine line;
  line.usage = "tektite check SCENE.toml [--variant V] [--set KEY=VALUE]... [--apply FILE.toml]";
  line.about =
      "Validates a scene, says in words what it means, forecasts what a run takes, and advises what could be saved.";
  scene.add_to(line);
  line.options.add_options()("apply", boost::program_options::value(&target)->value_name("FILE.toml"),
                             "write the scene with what is advised, beside it");
  if (boost::program_options::variables_map values; parse(line, arguments, values)) return exit_done;
  if (!target.empty()) check_target(target, scene.scene);
  for (const auto stage : {Stage::preprocess, Stage::postprocess})
    if (const int code = check_scene(stage, scene); code != exit_done) return code;
  const TemporaryFolder folder;
  const auto particles = folder.file("particles.h5"), advice = folder.file("advice");
  if (const int code = make_particles(scene, particles, Show::nothing); code != exit_done) return code;
  if (const int code = run_stage(Stage::solve, {"--check", particles, "--advice", advice}); code != exit_done)
    return code;
  if (!target.empty()) write_reduced(scene, advice, target);
  return exit_done;
}

}  // namespace tektite::front
