// tektite resume: goes on from the newest snapshot of a run that was interrupted, or from its particles where it has
// none yet.

#include <filesystem>

#include "core/error.hpp"
#include "front/commands.hpp"
#include "front/stages_of_a_run.hpp"

namespace tektite::front {

int resume(const Words& arguments) {
  namespace po = boost::program_options;
  std::string folder;
  std::string end;
  int threads = 0;
  CommandLine line;
  line.usage = "tektite resume DIR [--end TIME] [--threads N]";
  line.about =
      "Goes on from the newest snapshot of a run, bit for bit as if it had not stopped; then measures and draws.\nWith "
      "--end it goes on to another end than its scene's; that of a run that had come to its end stays as a snapshot.";
  line.options.add_options()("end", po::value(&end)->value_name("TIME"), "a new time.end, such as \"20 us\"")(
      "threads", po::value(&threads)->value_name("N"),
      "threads to compute with; else all processors, if each has five hundred particles");
  line.hidden.add_options()("DIR", po::value(&folder)->required());
  line.positional.add("DIR", 1);
  po::variables_map values;
  if (parse(line, arguments, values)) return exit_done;
  if (!std::filesystem::is_directory(folder))
    throw InputError({{folder, 0}, {}, {}, "there is no such folder", "the folder of a run"});
  Words options{"--resume"};
  if (values.contains("threads")) options.insert(options.end(), {"--threads", std::to_string(threads)});
  if (values.contains("end")) options.insert(options.end(), {"--end", end});
  const RunLock lock(folder);
  return solve_and_show(folder, lock, options);
}

}  // namespace tektite::front
