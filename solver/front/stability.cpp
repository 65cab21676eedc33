// tektite stability: has waves on lattices analysed as a study says, and the maps drawn.

#include <filesystem>

#include "core/error.hpp"
#include "core/run_lock.hpp"
#include "core/stability_study.hpp"
#include "front/commands.hpp"

namespace tektite::front {

int stability(const Words& arguments) {
  namespace po = boost::program_options;
  namespace fs = std::filesystem;
  std::string file, folder;
  int threads = 0;
  CommandLine line;
  line.usage = "tektite stability STUDY.toml [-o DIR] [--threads N]";
  line.about =
      "Linearises the step of each scheme of a study on a lattice and maps which waves grow, over stress and h/δ and "
      "over wave number and direction; finds the largest stable time steps.";
  line.options.add_options()("output,o", po::value(&folder)->value_name("DIR"), "folder of the study; else runs/NAME")(
      "threads", po::value(&threads)->value_name("N")->default_value(0), "threads to use (0: all that there are)");
  line.hidden.add_options()("STUDY.toml", po::value(&file)->required());
  line.positional.add("STUDY.toml", 1);
  po::variables_map values;
  if (parse(line, arguments, values)) return exit_done;

  auto document = Document::load(file, "", {});
  auto root = document.root();
  const auto study = read_stability_study(root);
  root.finish();
  if (folder.empty()) folder = (fs::path("runs") / study.name).string();
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw InputError({{folder, 0}, {}, {}, "this is no folder", "a folder, or a new name"});
  const RunLock lock(folder);
  const int code = run_stage(Stage::solve, {"--stability", file, "-o", folder, "--threads", std::to_string(threads)});
  return code != exit_done ? code : run_stage(Stage::postprocess, {"--stability", file, "-o", folder});
}

}  // namespace tektite::front
