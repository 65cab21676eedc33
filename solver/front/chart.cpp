// tektite chart: runs what a study names and has it charted.

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "core/error.hpp"
#include "core/run_lock.hpp"
#include "core/study.hpp"
#include "core/system_words.hpp"
#include "core/version.hpp"
#include "core/write_beside.hpp"
#include "front/commands.hpp"
#include "front/several.hpp"

namespace tektite::front {
namespace {

namespace fs = std::filesystem;

/// What the command line of `chart` says.
struct Order {
  std::string study;
  fs::path folder;
  int jobs = 1;
  int threads = 1;
  bool replace = false;
};

/// The files of a member: its run, what it printed, why it failed, and the scene of its last end.
struct MemberFiles {
  fs::path run, log, faults, failure, scene;

  MemberFiles(const fs::path& folder, const Member& member)
      : run(folder / "runs" / member.name),
        log(folder / "runs" / (member.name + ".log")),
        faults(folder / "runs" / (member.name + ".faults")),
        failure(folder / "runs" / (member.name + ".failed")),
        scene(folder / "runs" / (member.name + ".scene.toml")) {}
};

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What decides over a member's result: the version and the effective scene, without the places of its keys.
std::string identity_of(const Member& member) {
  const auto text = member.load().text();
  return fmt::format("# tektite {}\n{}", version, text.substr(0, text.find("\n#@ ")));
}

bool is_done(const MemberFiles& files, const std::string& identity) {
  if (!fs::exists(files.scene) || content_of(files.scene) != identity) return false;
  return fs::exists(files.failure) || fs::exists(files.run / "measurements.json");
}

/// The error that a failed program has told, without its own name and in one line.
std::string reason_of(const MemberFiles& files, int code) {
  if (code < 0) return fmt::format("ended by signal {} ({})", -code, words_for_signal(-code));
  std::istringstream lines(content_of(files.faults));
  const std::string mark = ": error: ";
  for (std::string line; std::getline(lines, line);)
    if (const auto at = line.find(mark); at != std::string::npos) return line.substr(at + mark.size());
  return fmt::format("ended with exit code {}", code);
}

Job job_of(const Member& member, const MemberFiles& files, const Order& order) {
  Words words{"run", member.scene, "-o", files.run.string(), "--replace", "--no-pictures"};
  words.insert(words.end(), {"--threads", std::to_string(order.threads)});
  if (!member.variant.empty()) words.insert(words.end(), {"--variant", member.variant});
  for (const auto& setting : member.settings) words.insert(words.end(), {"--set", setting});
  return {words, files.log.string(), files.faults.string()};
}

/// Runs the members that are not done, cheapest first: the coarsest of every line, then the next ones.
void run_members(const Study& study, const Order& order) {
  std::vector<const Member*> members;
  std::vector<std::string> identities;
  std::vector<Job> jobs;
  for (std::size_t k = 0, left = 1; left > 0; ++k) {
    left = 0;
    for (const auto& line : study.lines) {
      if (k >= line.members.size()) continue;
      ++left;
      const MemberFiles files(order.folder, line.members[k]);
      const auto identity = identity_of(line.members[k]);
      if (!order.replace && is_done(files, identity)) {
        fmt::print("{}: done already\n", line.members[k].name);
        continue;
      }
      fs::remove(files.scene);
      fs::remove(files.failure);
      fs::remove_all(files.run);
      members.push_back(&line.members[k]);
      identities.push_back(identity);
      jobs.push_back(job_of(line.members[k], files, order));
    }
  }
  std::fflush(stdout);
  std::size_t count = 0;
  run_several(jobs, order.jobs, [&](std::size_t job, int code) {
    const MemberFiles files(order.folder, *members[job]);
    const auto reason = code == exit_done ? std::string() : reason_of(files, code);
    if (code != exit_done) write_text_beside(files.failure.string(), reason + '\n');
    write_text_beside(files.scene.string(), identities[job]);
    fmt::print("{} of {}: {}{}{}\n", ++count, jobs.size(), members[job]->name,
               reason.empty() ? "" : " failed: ", reason);
    std::fflush(stdout);
  });
}

/// Nullopt where --help or --version was all that was asked. Throws InputError.
std::optional<Order> read_order(const Words& arguments) {
  namespace po = boost::program_options;
  Order order;
  std::string output;
  CommandLine line;
  line.usage = "tektite chart STUDY.toml [-o DIR] [--jobs N] [--threads N]";
  line.about =
      "Runs the scenes of a study at their resolutions and charts error against processor time. What is done already "
      "is not done again; a run that fails is named and ends nothing.";
  line.options.add_options()("output,o", po::value(&output)->value_name("DIR"), "folder of the study; else runs/NAME")(
      "jobs", po::value(&order.jobs)->value_name("N"), "runs at the same time; else as many as processors allow")(
      "threads", po::value(&order.threads)->value_name("N")->default_value(1), "threads of each run")(
      "replace", po::bool_switch(&order.replace), "do again what is done");
  line.hidden.add_options()("STUDY.toml", po::value(&order.study)->required());
  line.positional.add("STUDY.toml", 1);
  po::variables_map values;
  if (parse(line, arguments, values)) return std::nullopt;
  if (order.threads < 1) throw InputError("--threads must be at least 1");
  if (!values.contains("jobs"))
    order.jobs = std::max(1, static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN)) / order.threads);
  if (order.jobs < 1) throw InputError("--jobs must be at least 1");
  order.folder = output;
  return order;
}

}  // namespace

int chart(const Words& arguments) {
  auto order = read_order(arguments);
  if (!order) return exit_done;
  auto document = Document::load(order->study, "", {});
  auto root = document.root();
  const auto study = read_study(root);
  root.finish();
  if (order->folder.empty()) order->folder = fs::path("runs") / study.name;
  if (fs::exists(order->folder) && !fs::is_directory(order->folder))
    throw InputError({{order->folder.string(), 0}, {}, {}, "this is no folder", "a folder, or a new name"});

  // What the runs are judged by is found wrong before anything is computed.
  if (const int code = run_stage(Stage::postprocess, {"--chart", order->study, "--check"}); code != exit_done)
    return code;
  const RunLock lock(order->folder);  // two charts in one folder would spoil each other's runs
  fs::create_directories(order->folder / "runs");
  run_members(study, *order);
  return run_stage(Stage::postprocess, {"--chart", order->study, "-o", order->folder.string()});
}

}  // namespace tektite::front
