// tektite-postprocess: from snapshots to numbers, ParaView files and pictures.

#include "core/error.hpp"
#include "core/program.hpp"
#include "postprocess/page/page.hpp"
#include "postprocess/pipeline.hpp"
#include "postprocess/study/chart_study.hpp"
#include "postprocess/study/stability_maps.hpp"

namespace {

using namespace tektite;
namespace po = boost::program_options;

/// What the command line says.
struct Order {
  PostprocessOptions options;
  std::string study, stability;
  std::vector<std::string> runs;
};

CommandLine command_line(Order& order) {
  auto& options = order.options;
  CommandLine line;
  line.usage =
      "tektite-postprocess DIR|FILE.h5 [options]\n       tektite-postprocess --check SCENE.toml [options]\n"
      "       tektite-postprocess --chart STUDY.toml -o DIR|--check\n       tektite-postprocess --stability STUDY.toml "
      "-o DIR\n       tektite-postprocess --page -o "
      "FILE.html DIR...";
  line.about =
      "Measures a run, writes it for ParaView and draws it; can be run again with other measures and pictures.";
  line.options.add_options()("check", "validate the measures and pictures of a scene file; computes nothing")(
      "chart", po::value(&order.study)->value_name("STUDY.toml"),
      "chart the runs that this study has left in the folder")(
      "stability", po::value(&order.stability)->value_name("STUDY.toml"),
      "draw what this study of stability has left in the folder")("page", "write one page about the runs")(
      "output,o", po::value(&options.output)->value_name("PLACE"),
      "folder to write to instead of the run's; the page's file")(
      "scene", po::value(&options.scene)->value_name("SCENE.toml"), "take measures and pictures from this scene file")(
      "variant", po::value(&options.variant)->value_name("V"),
      "variant of that scene file, or of the run, which picks the references")(
      "set", po::value(&options.settings)->value_name("KEY=VALUE")->composing(), "KEY=VALUE laid over the scene file")(
      "reference", po::value(&options.reference)->value_name("FILE.toml"), "file of published values to compare with")(
      "no-pictures", "numbers and ParaView files only");
  line.hidden.add_options()("run", po::value(&order.runs));
  line.positional.add("run", -1);
  return line;
}

/// Where to write to; throws InputError, with these words, where the command line does not say.
const std::string& output_of(const Order& order, const char* missing) {
  if (order.options.output.empty()) throw InputError(missing);
  return order.options.output;
}

int chart(const Order& order, bool check) {
  if (!check)
    return chart_study(order.study, output_of(order, "--chart needs the folder of the study: -o DIR")) ? exit_done
                                                                                                       : exit_failed;
  check_study(order.study);
  return exit_done;
}

int run(int argc, const char* const* argv) {
  Order order;
  auto line = command_line(order);
  po::variables_map values;
  if (parse_command_line(line, argc, argv, values)) return exit_done;
  if (!order.study.empty()) return chart(order, values.contains("check"));
  if (!order.stability.empty()) {
    draw_stability(order.stability, output_of(order, "--stability needs the folder of the study: -o DIR"));
    return exit_done;
  }
  if (order.runs.empty()) throw InputError("nothing to do: give the folder of a run; see --help");
  if (values.contains("page")) {
    write_page(order.runs, output_of(order, "--page needs the file of the page: -o FILE.html"));
    return exit_done;
  }
  if (order.runs.size() > 1) throw InputError("one folder at a time; see --help");
  order.options.run = order.runs.front();
  order.options.pictures = !values.contains("no-pictures");
  if (values.contains("check")) {
    order.options.scene = order.options.run;
    check_scene(order.options);
  } else {
    postprocess(order.options);
  }
  return exit_done;
}

}  // namespace

int main(int argc, char** argv) {
  return tektite::run_program("tektite-postprocess", [&] { return run(argc, argv); });
}
