// tektite-solve: from particles to a computed impact.

#include "core/error.hpp"
#include "core/program.hpp"
#include "parallel/program_on_ranks.hpp"
#include "parallel/ranks.hpp"
#include "parallel/threads.hpp"
#include "run/check.hpp"
#include "run/run.hpp"
#include "stability/analyse.hpp"

namespace {

using namespace tektite;
namespace po = boost::program_options;

CommandLine command_line() {
  CommandLine line;
  line.usage =
      "tektite-solve DIR [--resume [--end TIME]] [--threads N] [--trap-floating-point]\n       tektite-solve --check "
      "FILE.h5 "
      "[--advice FILE]\n"
      "       tektite-solve --stability STUDY.toml -o DIR";
  line.about =
      "Computes the run whose initial particles are DIR/particles.h5; leaves DIR/snapshots/*.h5, DIR/history.csv,\n"
      "DIR/solve.json and DIR/run.log.";
  line.options.add_options()("resume", "go on from the newest snapshot")(
      "end", po::value<std::string>()->value_name("TIME")->default_value({}, ""), "with --resume: a new time.end")(
      "threads", po::value<int>()->value_name("N")->default_value(0),
      "threads to use (0: all processors, if each has five hundred particles)")(
      "check", po::value<std::string>()->value_name("FILE.h5"),
      "say what a run of these particles would do; compute nothing that is kept")(
      "advice", po::value<std::string>()->value_name("FILE"),
      "with --check: say what could be saved, and write the settings for it here")(
      "trap-floating-point",
      "end at the first division by zero, overflow or undefined result, and say where: for whoever writes a formula")(
      "stability", po::value<std::string>()->value_name("STUDY.toml"),
      "analyse how waves grow on lattices, as this study says")("output,o", po::value<std::string>()->value_name("DIR"),
                                                                "folder of the study");
  line.hidden.add_options()("folder", po::value<std::string>())("lock", po::value<int>()->default_value(-1));
  line.positional.add("folder", 1);
  return line;
}

int solve(int argc, const char* const* argv) {
  auto line = command_line();
  po::variables_map values;
  if (parse_command_line(line, argc, argv, values)) return exit_done;
  const auto text = [&](const char* name) { return values[name].as<std::string>(); };
  const int threads = values["threads"].as<int>();
  constexpr int most_threads = 4096;
  if (threads < 0 || threads > most_threads) throw InputError("--threads must be a number from 0 to 4096");
  if (ranks() > 1 && (values.contains("check") || values.contains("stability")))
    throw InputError("several processes compute a run, and nothing else");
  if (values.contains("check")) {
    CheckOptions checking{text("check"), std::nullopt, threads};
    if (values.contains("advice")) checking.advice = text("advice");
    check(checking);
    return exit_done;
  }
  if (values.contains("stability")) {
    if (!values.contains("output")) throw InputError("--stability needs the folder of the study: -o DIR");
    analyse_stability(text("stability"), text("output"), threads);
    return exit_done;
  }
  if (!values.contains("folder")) throw InputError("the folder of the run is missing; see --help");
  if (!text("end").empty() && !values.contains("resume"))
    throw InputError("--end goes with --resume; a run that starts takes time.end of its scene");
  const RunOptions options{text("folder"), values.contains("resume"), text("end"),
                           threads,        values["lock"].as<int>(),  values.contains("trap-floating-point")};
  return run(options) ? exit_done : exit_failed;
}

}  // namespace

int main(int argc, char** argv) {
  wait_briefly(argv);
  return run_program_on_ranks("tektite-solve", [&] { return solve(argc, argv); });
}
