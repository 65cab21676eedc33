// tektite-preprocess: a scene's geometry becomes particles.

#include <omp.h>

#include <iostream>

#include "core/error.hpp"
#include "core/program.hpp"
#include "parallel/agreed.hpp"
#include "parallel/program_on_ranks.hpp"
#include "preprocess/build_particles.hpp"
#include "preprocess/particle_file.hpp"

namespace {

using namespace tektite;
namespace po = boost::program_options;

CommandLine command_line() {
  CommandLine line;
  line.usage = "tektite-preprocess SCENE.toml [--variant V] [--set KEY=VALUE]... (-o FILE.h5 | --check)";
  line.about =
      "Fills the bodies of a scene with particles and writes them, with the effective scene, as the state at time 0.";
  line.options.add_options()("variant", po::value<std::string>()->value_name("V")->default_value("", ""),
                             "the [variant.NAME] to compute")(
      "set", po::value<std::vector<std::string>>()->value_name("KEY=VALUE")->composing()->default_value({}, ""),
      "override a key, as KEY=VALUE")("output,o", po::value<std::string>()->value_name("FILE.h5"),
                                      "the particle file to write")("check", "do everything but write")(
      "threads", po::value<int>()->value_name("N"), "number of threads; all by default")(
      "most-particles", po::value<double>()->value_name("N")->default_value(preprocess::default_most_particles, "2e8"),
      "refuse scenes with more particles than this");
  line.hidden.add_options()("scene", po::value<std::string>());
  line.positional.add("scene", 1);
  return line;
}

int run(int argc, const char* const* argv) {
  auto line = command_line();
  po::variables_map values;
  if (parse_command_line(line, argc, argv, values)) return exit_done;
  if (!values.contains("scene")) throw InputError("no scene is given; see --help");
  const bool check = values.contains("check");
  if (check == values.contains("output")) throw InputError("give either -o FILE.h5 or --check; see --help");
  if (values.contains("threads")) {
    if (values["threads"].as<int>() < 1) throw InputError("--threads must be at least 1");
    omp_set_num_threads(values["threads"].as<int>());
  }

  const double most_particles = values["most-particles"].as<double>();
  if (!(most_particles >= 1.0)) throw InputError("--most-particles must be at least 1");

  auto document = agreed([&] {
    return Document::load(values["scene"].as<std::string>(), values["variant"].as<std::string>(),
                          values["set"].as<std::vector<std::string>>());
  });
  const auto result = preprocess::build_particles(document, most_particles);
  std::cout << preprocess::in_words(result);
  if (check) return exit_done;
  preprocess::write_particle_file(result, values["output"].as<std::string>());
  std::cout << "written to " << values["output"].as<std::string>() << '\n';
  return exit_done;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program_on_ranks("tektite-preprocess", [&] { return run(argc, argv); });
}
