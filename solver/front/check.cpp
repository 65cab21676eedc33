// tektite check: every stage validates its part of the scene and says in words what it would do.

#include <cstdlib>
#include <filesystem>

#include "core/error.hpp"
#include "front/commands.hpp"
#include "front/scene_arguments.hpp"
#include "front/stages_of_a_run.hpp"

namespace tektite::front {
namespace {

/// A folder that is removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    auto name = (std::filesystem::temp_directory_path() / "tektite-check-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw RunError(name + ": this folder cannot be made");
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

}  // namespace

int check(const Words& arguments) {
  SceneArguments scene;
  CommandLine line;
  line.usage = "tektite check SCENE.toml [--variant V] [--set KEY=VALUE]...";
  line.about = "Validates a scene, says in words what it means, and estimates what a run takes.";
  scene.add_to(line);
  if (boost::program_options::variables_map values; parse(line, arguments, values)) return exit_done;
  for (const auto stage : {Stage::preprocess, Stage::postprocess})
    if (const int code = check_scene(stage, scene); code != exit_done) return code;
  const TemporaryFolder folder;
  const auto particles = folder.file("particles.h5");
  if (const int code = make_particles(scene, particles, Show::nothing); code != exit_done) return code;
  return run_stage(Stage::solve, {"--check", particles});
}

}  // namespace tektite::front
