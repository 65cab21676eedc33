// tektite chart --launcher slurm as a user meets it, by a real Slurm: what comes out is what the local launcher leaves;
// runs that Slurm or a signal ends are run again, none twice; a chart that is killed finds its tasks again.
#include <catch2/catch.hpp>
#include <sstream>

#include "slurm/cluster.hpp"

namespace {

namespace fs = std::filesystem;
using namespace tektite::test;
using Catch::Matchers::Contains;

/// Two runs of some seconds each; `more` is laid over both.
std::string long_study(const std::string& more = "") {
  return "name = 'long'\nscene = 'scene.toml'\nresolutions = [{ factor = 0.5 }]\n"
         "set = ['time.end=\"150 us\"', 'output.snapshots=\"50 us\"'" +
         more +
         "]\n[[error]]\nmeasure = 'energy_drift'\n[line.one]\n[line.two]\n"
         "set = [\"viscosity = { model = 'monaghan', alpha = 2.0, beta = 2.0 }\"]\n";
}

/// The small impact at two resolutions, and a line that cannot run.
const std::string short_study =
    "name = 'short'\nscene = 'scene.toml'\nresolutions = [{ factor = 4 }, { factor = 2 }]\n"
    "[[error]]\nmeasure = 'energy_drift'\n[line.eulerian]\n"
    "[line.impossible]\nset = [\"scheme.correction = 'quadratic'\"]\n";

class Workplace {
 public:
  explicit Workplace(const std::string& study) { write(study); }
  void write(const std::string& study) const { std::ofstream(small.folder("study.toml")) << study; }
  std::vector<std::string> words(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {TEKTITE_PROGRAM, "chart", "study.toml", "-o", out, "--launcher", "slurm"});
    return more;
  }
  Outcome chart(std::vector<std::string> more = {}) const { return small.program(words(std::move(more))); }
  /// The same, with what it says on standard error in the file `faults`.
  std::vector<std::string> words_that_keep_faults() const {
    auto all = words();
    all.insert(all.begin(), {"/bin/sh", "-c", "exec \"$@\" 2>faults", "sh"});
    return all;
  }
  std::string content(const std::string& file) const { return content_of(out + "/" + file); }
  /// A run computes steps.
  bool is_at_work(const std::string& run) const { return content("runs/" + run + "/history.csv").size() > 500; }
  /// The job of a submission; empty until sbatch has told it.
  std::string job(int submission) const {
    const auto said = content("slurm/" + std::to_string(submission) + ".job");
    return said.ends_with('\n') ? said.substr(0, said.size() - 1) : std::string();
  }

  SmallRun small{"eulerian"};
  std::string out = small.folder("out");
};

/// A table without what depends on the machine: processor time, and who is in front by it.
std::string without_times(const std::string& table) {
  std::string kept;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line); kept += '\n') {
    std::istringstream cells(line);
    int column = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++column)
      if (column != 5 && column != 8) kept += cell + ',';
  }
  return kept;
}

int slurm(const std::string& words) { return std::system((words + " >/dev/null 2>&1").c_str()); }

/// The process of a run: `tektite run ... -o FOLDER ...`.
pid_t process_of(const std::string& folder) {
  const auto words = std::string("run\0", 4);
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const auto line = content_of(entry.path() / "cmdline");
    if (line.starts_with(TEKTITE_PROGRAM + std::string(1, '\0') + words) &&
        line.find(std::string(1, '\0') + folder + '\0') != std::string::npos)
      return std::stoi(entry.path().filename());
  }
  return 0;
}

TEST_CASE("Slurm: a study leaves what it leaves on this machine, apart from times") {
  const Cluster cluster;
  const Workplace place(short_study);
  const auto outcome = place.chart({"--sbatch", "partition=main", "--jobs", "1"});
  INFO(outcome.faults << outcome.output);
  REQUIRE(outcome.code == 0);
  CHECK_THAT(outcome.output, Contains("4 runs are tasks of Slurm's job 1 (to give up: Ctrl-C, then `scancel 1`)") &&
                                 Contains("4 of 4: ") && Contains("impossible-2 failed: "));
  CHECK(cluster.starts() == 4);
  const auto local = place.small.program({TEKTITE_PROGRAM, "chart", "study.toml", "-o", "local"});
  REQUIRE(local.code == 0);
  const auto table = place.content("chart.csv");
  CHECK_THAT(table, Contains("\neulerian,2,0.002,"));
  CHECK(without_times(table) == without_times(content_of(place.small.folder("local/chart.csv"))));
  const auto again = place.chart();
  CHECK(again.code == 0);
  CHECK_THAT(again.output, Contains("impossible-4: done already") && Contains("eulerian-2: done already"));
  CHECK(cluster.starts() == 4);
}

TEST_CASE("Slurm: a run whose task is cancelled or whose process is killed is run again, none twice") {
  const Cluster cluster;
  const Workplace place(long_study());
  Outcome outcome;
  std::thread charting([&] { outcome = place.chart(); });
  const bool cancelled = comes_about([&] { return place.is_at_work("one-0.5"); }) && slurm("scancel 1_0") == 0;
  const auto killed = comes_about([&] { return place.is_at_work("two-0.5"); });
  const auto process = process_of(place.out + "/runs/two-0.5");
  if (process > 0) ::kill(process, SIGKILL);
  charting.join();
  INFO(outcome.faults << outcome.output);
  CHECK(cancelled);
  CHECK(killed);
  CHECK(process > 0);
  CHECK(outcome.code == 0);
  CHECK_THAT(outcome.output, Contains("one-0.5: task 1_0 has ended without it, CANCELLED: ") &&
                                 Contains("two-0.5: task 1_1 has ended without it, FAILED") && Contains("2 of 2: "));
  CHECK_THAT(place.content("chart.csv"), Contains("\none,0.5,0.0005,") && Contains("\ntwo,0.5,0.0005,"));
  CHECK(cluster.starts() == 4);
}

TEST_CASE("Slurm: a run whose tasks are ended from outside each time is named as failed") {
  const Cluster cluster;
  const Workplace place(
      "name = 'one'\nscene = 'scene.toml'\nresolutions = [{ factor = 2 }]\n[[error]]\n"
      "measure = 'energy_drift'\n[line.one]\n");
  Outcome outcome;
  std::thread charting([&] { outcome = place.chart({"--sbatch", "hold"}); });
  bool cancelled = true;
  for (int n = 1; n <= 3; ++n)
    cancelled =
        comes_about([&] { return !place.job(n).empty(); }) && slurm("scancel " + place.job(n)) == 0 && cancelled;
  charting.join();
  CHECK(cancelled);
  CHECK(outcome.code == 1);
  CHECK_THAT(outcome.output, Contains("one-2 failed: task ") && Contains("CANCELLED, after 3 submissions"));
  CHECK_FALSE(fs::exists(place.out + "/runs/one-2.task"));
  CHECK(cluster.starts() == 0);
}

TEST_CASE("Slurm: a chart that is interrupted or killed finds its tasks again") {
  const Cluster cluster;
  const Workplace place(long_study());
  auto first = place.small.start(place.words());
  REQUIRE(comes_about([&] { return place.is_at_work("one-0.5"); }));
  CHECK(first.end_by(SIGKILL) == -1);

  // While Slurm has them in hand, nothing else is done about these runs.
  const auto local = place.small.program({TEKTITE_PROGRAM, "chart", "study.toml", "-o", place.out});
  CHECK(local.code == 2);
  CHECK_THAT(local.faults, Contains("one-0.5.task: this run is a task of Slurm"));
  place.write(long_study(", 'output.history=7'"));
  const auto changed = place.chart();
  CHECK(changed.code == 2);
  CHECK_THAT(changed.faults, Contains("is task 1_0 of Slurm") && Contains("scancel 1_0"));
  place.write(long_study());

  const auto queue = place.out + "/slurm/queue";
  fs::remove(queue);
  auto second = place.small.start(place.words_that_keep_faults());
  REQUIRE(comes_about([&] { return fs::exists(queue); }));
  CHECK(second.end_by(SIGINT) == 1);
  CHECK_THAT(content_of(place.small.folder("faults")),
             Contains("interrupted; Slurm goes on with the runs") && Contains("`scancel 1` cancels them"));
  ::setenv("SQUEUE_PARTITION", "other", 1);  // hides tasks from who does not take care
  const auto third = place.chart();
  ::unsetenv("SQUEUE_PARTITION");
  INFO(third.faults << third.output);
  CHECK(third.code == 0);
  CHECK_THAT(third.output, Contains("of Slurm already") && !Contains("of Slurm's job"));
  CHECK_THAT(place.content("chart.csv"), Contains("\none,0.5,0.0005,") && Contains("\ntwo,0.5,0.0005,"));
  CHECK(cluster.starts() == 2);
}

TEST_CASE("Slurm: what sbatch refuses is told once, and nothing is left of it") {
  const Cluster cluster;
  const Workplace place(short_study);
  const auto refused = place.chart({"--sbatch", "partition=nowhere"});
  CHECK(refused.code == 1);
  CHECK(refused.faults ==
        "tektite: error: sbatch has submitted nothing: invalid partition specified: nowhere; Batch job submission "
        "failed: Invalid partition name specified\n");
  CHECK_THAT(place.chart({"--sbatch", "help"}).faults, Contains("sbatch has submitted nothing: it names no job"));
  CHECK(fs::is_empty(place.out + "/runs"));
  // As where sbatch speaks to another cluster than squeue.
  place.small.program({"/bin/sh", "-c", "mkdir other && echo '#!/bin/sh' >other/squeue && chmod +x other/squeue"});
  auto words = place.words({"--sbatch", "hold"});
  words.insert(words.begin(), {"/bin/sh", "-c", "PATH=$PWD/other:$PATH exec \"$@\"", "sh"});
  const auto hidden = place.small.program(words);
  CHECK(hidden.code == 1);
  CHECK_THAT(hidden.faults, Contains("squeue does not show job 1, which sbatch has submitted: cancel it"));
  CHECK(fs::is_empty(place.out + "/runs"));
}

}  // namespace
