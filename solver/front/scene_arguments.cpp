#include "front/scene_arguments.hpp"

#include <filesystem>

namespace tektite::front {

void SceneArguments::add_to(CommandLine& line) {
  namespace po = boost::program_options;
  line.options.add_options()("variant", po::value(&variant)->value_name("V"), "the variant of the scene, [variant.V]")(
      "set", po::value(&settings)->value_name("KEY=VALUE"), "lay a value over the scene; may be repeated");
  line.hidden.add_options()("SCENE.toml", po::value(&scene)->required());
  line.positional.add("SCENE.toml", 1);
}

Words SceneArguments::words() const {
  Words words{scene};
  if (!variant.empty()) words.insert(words.end(), {"--variant", variant});
  for (const auto& setting : settings) words.insert(words.end(), {"--set", setting});
  return words;
}

Document SceneArguments::load() const { return Document::load(scene, variant, settings); }

std::string SceneArguments::run_name() const {
  auto document = load();
  auto root = document.root();
  const auto name = read_scene(root, Stage::solve).name;
  return variant.empty() ? name : name + "-" + variant;
}

std::string SceneArguments::reference() const {
  const auto path = std::filesystem::path(scene).parent_path() / "reference.toml";
  return std::filesystem::exists(path) ? path.string() : std::string();
}

}  // namespace tektite::front
