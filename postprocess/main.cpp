// tektite-postprocess: from snapshots to numbers, ParaView files and pictures.

#include "core/error.hpp"
#include "core/program.hpp"
#include "postprocess/page/page.hpp"
#include "postprocess/pipeline.hpp"
#include "postprocess/study/chart_study.hpp"
#include "postprocess/study/stability_maps.hpp"

namespace {

int run(int argc, const char* const* argv) {
  namespace po = boost::program_options;
  tektite::PostprocessOptions options;
  std::string study, stability;
  std::vector<std::string> runs;
  tektite::CommandLine line;
  line.usage =
      "tektite-postprocess DIR|FILE.h5 [options]\n       tektite-postprocess --check SCENE.toml [options]\n"
      "       tektite-postprocess --chart STUDY.toml -o DIR|--check\n       tektite-postprocess --stability STUDY.toml "
      "-o DIR\n       tektite-postprocess --page -o "
      "FILE.html DIR...";
  line.about =
      "Measures a run, writes it for ParaView and draws it; can be run again with other measures and pictures.";
  line.options.add_options()("check", "validate the measures and pictures of a scene file; computes nothing")(
      "chart", po::value(&study)->value_name("STUDY.toml"), "chart the runs that this study has left in the folder")(
      "stability", po::value(&stability)->value_name("STUDY.toml"),
      "draw what this study of stability has left in the folder")("page", "write one page about the runs")(
      "output,o", po::value(&options.output)->value_name("PLACE"),
      "folder to write to instead of the run's; the page's file")(
      "scene", po::value(&options.scene)->value_name("SCENE.toml"), "take measures and pictures from this scene file")(
      "variant", po::value(&options.variant)->value_name("V"),
      "variant of that scene file, or of the run, which picks the references")(
      "set", po::value(&options.settings)->value_name("KEY=VALUE")->composing(), "KEY=VALUE laid over the scene file")(
      "reference", po::value(&options.reference)->value_name("FILE.toml"), "file of published values to compare with")(
      "no-pictures", "numbers and ParaView files only");
  line.hidden.add_options()("run", po::value(&runs));
  line.positional.add("run", -1);
  po::variables_map values;
  if (tektite::parse_command_line(line, argc, argv, values)) return tektite::exit_done;
  if (!study.empty()) {
    if (values.contains("check")) {
      tektite::check_study(study);
      return tektite::exit_done;
    }
    if (options.output.empty()) throw tektite::InputError("--chart needs the folder of the study: -o DIR");
    return tektite::chart_study(study, options.output) ? tektite::exit_done : tektite::exit_failed;
  }
  if (!stability.empty()) {
    if (options.output.empty()) throw tektite::InputError("--stability needs the folder of the study: -o DIR");
    tektite::draw_stability(stability, options.output);
    return tektite::exit_done;
  }
  if (runs.empty()) throw tektite::InputError("nothing to do: give the folder of a run; see --help");
  if (values.contains("page")) {
    if (options.output.empty()) throw tektite::InputError("--page needs the file of the page: -o FILE.html");
    tektite::write_page(runs, options.output);
    return tektite::exit_done;
  }
  if (runs.size() > 1) throw tektite::InputError("one folder at a time; see --help");
  options.run = runs.front();
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
