// tektite-postprocess: from snapshots to numbers, ParaView files and pictures.

#include "core/error.hpp"
#include "core/program.hpp"
#include "postprocess/pipeline.hpp"

namespace {

int run(int argc, const char* const* argv) {
  namespace po = boost::program_options;
  tektite::PostprocessOptions options;
  tektite::CommandLine line;
  line.usage = "tektite-postprocess DIR|FILE.h5 [options]\n       tektite-postprocess --check SCENE.toml [options]";
  line.about =
      "Measures a run, writes it for ParaView and draws it; can be run again with other measures and pictures.";
  line.options.add_options()("check", "validate the measures and pictures of a scene file; computes nothing")(
      "output,o", po::value(&options.output), "folder to write to instead of the run's")(
      "scene", po::value(&options.scene), "take measures and pictures from this scene file")(
      "variant", po::value(&options.variant), "variant of that scene file, or of the run, which picks the references")(
      "set", po::value(&options.settings)->composing(), "KEY=VALUE laid over the scene file")(
      "reference", po::value(&options.reference), "file of published values to compare with")(
      "no-pictures", "numbers and ParaView files only");
  line.hidden.add_options()("run", po::value(&options.run));
  line.positional.add("run", 1);
  po::variables_map values;
  if (tektite::parse_command_line(line, argc, argv, values)) return tektite::exit_done;
  if (options.run.empty()) throw tektite::InputError("nothing to do: give the folder of a run; see --help");
  options.pictures = !values.contains("no-pictures");
  if (values.contains("check")) {
    options.scene = options.run;
    tektite::check_scene(options);
  } else {
    tektite::postprocess(options);
  }
  return tektite::exit_done;
}

}  // namespace

int main(int argc, char** argv) {
  return tektite::run_program("tektite-postprocess", [&] { return run(argc, argv); });
}
