#pragma once
// SCENE.toml [--variant V] [--set KEY=VALUE]..., which several commands take and hand on to the stages.

#include "core/document.hpp"
#include "core/program.hpp"
#include "front/stage.hpp"

namespace tektite::front {

struct SceneArguments {
  std::string scene;
  std::string variant;
  Words settings;

  /// Binds the options to this object, which must live until the command line is parsed.
  void add_to(CommandLine& line);
  /// As a stage takes them.
  Words words() const;
  /// The scene with variant and settings laid over it. Throws InputError.
  Document load() const;
  /// The scene's name, followed by the variant where there is one: it names a run. Throws InputError.
  std::string run_name() const;
  /// The published values that stand beside the scene; empty where there are none.
  std::string reference() const;
};

}  // namespace tektite::front
