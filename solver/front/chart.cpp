// tektite chart: runs what a study names and has it charted.

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>

#include "core/error.hpp"
#include "core/run_lock.hpp"
#include "core/study.hpp"
#include "core/version.hpp"
#include "core/write_beside.hpp"
#include "front/commands.hpp"
#include "front/launcher.hpp"

namespace tektite::front {
namespace {

namespace fs = std::filesystem;

struct NamedLauncher {
  std::string_view name;
  Launcher launch;
};
constexpr std::array<NamedLauncher, 2> launchers{{{"local", launch_locally}, {"slurm", launch_by_slurm}}};

Launcher launcher_named(const std::string& name) {
  Words known;
  for (const auto& launcher : launchers) {
    if (launcher.name == name) return launcher.launch;
    known.emplace_back(launcher.name);
  }
  throw InputError({{}, "--launcher", name, "there is no such launcher", join(known)});
}

/// What the command line of `chart` says.
struct Order {
  std::string study;
  Launcher launch = nullptr;
  Means means;
};

/// What decides over a member's result: the version and the effective scene, without the places of its keys.
std::string identity_of(const Member& member) {
  const auto text = member.load().text();
  return fmt::format("# tektite {}\n{}", version, text.substr(0, text.find("\n#@ ")));
}

bool is_done(const RunFiles& files, const std::string& identity) {
  if (!fs::exists(files.scene) || content_of(files.scene) != identity) return false;
  return fs::exists(files.failure) || fs::exists(files.run / "measurements.json");
}

Job job_of(const Member& member, const std::string& identity, const Means& means) {
  const RunFiles files(means.folder, member.name);
  Words words{"run", member.scene, "-o", files.run.string(), "--replace", "--no-pictures"};
  words.insert(words.end(), {"--threads", std::to_string(means.threads)});
  if (!member.variant.empty()) words.insert(words.end(), {"--variant", member.variant});
  for (const auto& setting : member.settings) words.insert(words.end(), {"--set", setting});
  return {member.name, identity, words, files};
}

/// The members that are not done, cheapest first: the coarsest of every line, then the next ones.
std::vector<Job> jobs_of(const Study& study, const Means& means) {
  std::vector<Job> jobs;
  for (std::size_t k = 0, left = 1; left > 0; ++k) {
    left = 0;
    for (const auto& line : study.lines) {
      if (k >= line.members.size()) continue;
      ++left;
      const auto& member = line.members[k];
      const auto identity = identity_of(member);
      if (!means.replace && is_done(RunFiles(means.folder, member.name), identity)) {
        fmt::print("{}: done already\n", member.name);
      } else {
        jobs.push_back(job_of(member, identity, means));
      }
    }
  }
  return jobs;
}

void run_members(const Study& study, const Order& order) {
  const auto jobs = jobs_of(study, order.means);
  std::fflush(stdout);
  std::size_t count = 0;
  order.launch(jobs, order.means, [&](std::size_t job, const std::string& failure) {
    const auto& files = jobs[job].files;
    if (!failure.empty()) write_text_beside(files.failure.string(), failure + '\n');
    write_text_beside(files.scene.string(), jobs[job].identity);
    fmt::print("{} of {}: {}{}{}\n", ++count, jobs.size(), jobs[job].name, failure.empty() ? "" : " failed: ", failure);
    std::fflush(stdout);
  });
}

/// Nullopt where --help or --version was all that was asked. Throws InputError.
std::optional<Order> read_order(const Words& arguments) {
  namespace po = boost::program_options;
  Order order;
  auto& means = order.means;
  std::string output, launcher;
  CommandLine line;
  line.usage = "tektite chart STUDY.toml [-o DIR] [--jobs N] [--threads N] [--launcher slurm]";
  line.about =
      "Runs the scenes of a study at their resolutions and charts error against processor time. What is done already "
      "is not done again; a run that fails is named and ends nothing.";
  line.options.add_options()("output,o", po::value(&output)->value_name("DIR"), "folder of the study; else runs/NAME")(
      "jobs", po::value(&means.jobs)->value_name("N"), "runs at the same time; else as many as there is room for")(
      "threads", po::value(&means.threads)->value_name("N")->default_value(1), "threads of each run")(
      "launcher", po::value(&launcher)->value_name("NAME")->default_value("local"),
      "local: runs on this machine; slurm: tasks of a job array on a cluster")(
      "sbatch", po::value(&means.sbatch)->value_name("OPTION"),
      "an option of sbatch for these tasks, such as partition=long; may be repeated")(
      "replace", po::bool_switch(&means.replace), "do again what is done");
  line.hidden.add_options()("STUDY.toml", po::value(&order.study)->required());
  line.positional.add("STUDY.toml", 1);
  po::variables_map values;
  if (parse(line, arguments, values)) return std::nullopt;
  if (means.threads < 1) throw InputError("--threads must be at least 1");
  if (values.contains("jobs") && means.jobs < 1) throw InputError("--jobs must be at least 1");
  order.launch = launcher_named(launcher);
  if (!means.sbatch.empty() && order.launch != launch_by_slurm) throw InputError("--sbatch is for --launcher slurm");
  means.folder = output;
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
  order->means.study = study.name;
  auto& folder = order->means.folder;
  if (folder.empty()) folder = fs::path("runs") / study.name;
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw InputError({{folder.string(), 0}, {}, {}, "this is no folder", "a folder, or a new name"});

  // What the runs are judged by is found wrong before anything is computed.
  if (const int code = run_stage(Stage::postprocess, {"--chart", order->study, "--check"}); code != exit_done)
    return code;
  const RunLock lock(folder);  // two charts in one folder would spoil each other's runs
  fs::create_directories(folder / "runs");
  run_members(study, *order);
  return run_stage(Stage::postprocess, {"--chart", order->study, "-o", folder.string()});
}

}  // namespace tektite::front
