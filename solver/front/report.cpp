// tektite report: one page about one run or several side by side.

#include "front/commands.hpp"

namespace tektite::front {

int report(const Words& arguments) {
  namespace po = boost::program_options;
  Words folders;
  std::string output;
  CommandLine line;
  line.usage = "tektite report DIR... [-o FILE.html]";
  line.about =
      "Writes one page about a run, or about several side by side: cost, measures beside published values, histories, "
      "pictures, scene. It needs nothing but itself.";
  line.options.add_options()("output,o", po::value(&output)->value_name("FILE.html"),
                             "the page; else DIR/report.html, of several runs report.html");
  line.hidden.add_options()("DIR", po::value(&folders)->required());
  line.positional.add("DIR", -1);
  if (po::variables_map values; parse(line, arguments, values)) return exit_done;
  if (output.empty()) output = folders.size() == 1 ? folders.front() + "/report.html" : "report.html";
  Words words{"--page", "-o", output};
  words.insert(words.end(), folders.begin(), folders.end());
  return run_stage(Stage::postprocess, words);
}

}  // namespace tektite::front
