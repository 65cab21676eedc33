// tektite chart as a user meets it: a tiny study, twice, with a member that fails, and wrong studies.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "support/program.hpp"

namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using tektite::test::content_of;
using tektite::test::run_in;
using tektite::test::TemporaryFolder;

/// A short bar whose elastic wave is exact, by two schemes and one that cannot run it.
const std::string scene = R"(
name = "bar"
space = "line"
spacing = "8 mm"
[material.metal]
density = "2785 kg/m3"
eos = { model = "linear", bulk_modulus = "79 GPa" }
[body.bar]
material = "metal"
shape = { type = "segment", lower = 0, upper = "0.4 m" }
velocity = { type = "pulse", speed = "0.1 m/s", centre = "0.2 m", width = "0.2 m" }
[time]
end = "5 us"
[measure.error_l1_pulse]
body = "bar"
speed = "0.1 m/s"
centre = "0.2 m"
width = "0.2 m"
wave_speed = "5326 m/s"
)";

const std::string study = R"(name = "tiny"
scene = "scene.toml"
resolutions = [{ factor = 2 }, { factor = 1 }]
target = 0.2
[[error]]
measure = "error_l1_pulse"
[line.eulerian]
[line.viscous]
set = ["viscosity = { model = 'monaghan', alpha = 2.0, beta = 2.0 }"]
[line.impossible]
title = "no such kernel"
set = ["smoothing.kernel = 'truncated-gaussian'", "scheme.type = 'msph'", "scheme.correction = 'mixed'"]
)";

struct Workplace {
  Workplace() {
    write("scene.toml", scene);
    write("study.toml", study);
  }
  void write(const std::string& file, const std::string& text) const { std::ofstream(folder.file(file)) << text; }
  std::string content(const std::string& file) const { return content_of(folder.file(file)); }
  tektite::test::Outcome chart(std::vector<std::string> words = {"study.toml", "-o", "out"}) const {
    words.insert(words.begin(), {TEKTITE_PROGRAM, "chart"});
    return run_in(folder.path(), words);
  }
  TemporaryFolder folder;
};

TEST_CASE("Chart: a study leaves table, page and pictures, names what failed, and is not done twice") {
  const Workplace place;
  const auto first = place.chart();
  INFO(first.faults << first.output);
  REQUIRE(first.code == 0);
  const auto page = place.content("out/chart.md");
  CHECK_THAT(page, Contains("| `eulerian` | 1 |") && Contains("* `impossible-2`, `impossible-1` failed: ") &&
                       Contains("Which is cheapest for an error of 20 %?"));
  CHECK_THAT(first.output, Contains(page));
  CHECK_THAT(first.output, Contains("impossible-1 failed: ") && Contains("correction"));
  CHECK_THAT(place.content("out/chart.csv"), Contains("\nviscous,1,0.008,50,"));
  CHECK_THAT(place.content("out/chart.png"), Catch::StartsWith("\x89PNG"));
  const auto drawing = place.content("out/chart.svg");
  CHECK_THAT(drawing, Contains("<svg") && Contains("viscous") && Contains("no such kernel (failed)"));

  SECTION("the second time nothing is run") {
    const auto written = fs::last_write_time(place.folder.file("out/runs/viscous-1/measurements.json"));
    const auto table = place.content("out/chart.csv");
    fs::remove(place.folder.file("out/chart.csv"));
    const auto second = place.chart();
    CHECK(second.code == 0);
    CHECK_THAT(second.output, Contains("impossible-1: done already") && Contains("viscous-1: done already"));
    CHECK(fs::last_write_time(place.folder.file("out/runs/viscous-1/measurements.json")) == written);
    CHECK(place.content("out/chart.csv") == table);
  }
  SECTION("what is missing or has changed is run, and nothing else") {
    fs::remove(place.folder.file("out/runs/eulerian-1.scene.toml"));  // as where the run was interrupted
    auto changed = study;
    changed.replace(changed.find("alpha = 2.0"), 11, "alpha = 1.0");
    place.write("study.toml", changed);
    const auto second = place.chart();
    CHECK(second.code == 0);
    CHECK_THAT(second.output,
               Contains("of 3: ") && Contains("eulerian-2: done already") && Contains("impossible-2: done already"));
    CHECK_THAT(second.output, !Contains("viscous-2: done already") && !Contains("eulerian-1: done already"));
  }
}

TEST_CASE("Chart: a study in which every run fails says so and fails") {
  const Workplace place;
  auto hopeless = study;
  hopeless.replace(hopeless.find("resolutions"), 0, "set = [\"scheme.courant = -1\"]\n");
  place.write("study.toml", hopeless);
  const auto outcome = place.chart();
  CHECK(outcome.code == 1);
  CHECK_THAT(outcome.output, Contains("`viscous-1`") && Contains("No run has a result."));
}

TEST_CASE("Chart: one that is interrupted says that the same command goes on, and keeps no result of what it ended") {
  const Workplace place;
  const auto put = [&](const std::string& program, const std::string& script) {
    place.write(program, "#!/bin/sh\n" + script);
    fs::permissions(place.folder.file(program), fs::perms::owner_all);
  };
  fs::copy(TEKTITE_PROGRAM, place.folder.file("tektite"));
  put("tektite-postprocess", "exit 0\n");
  // The first stage of a run interrupts the chart that has started it.
  put("tektite-preprocess",
      "read pid name state chart others < /proc/$PPID/stat\nread pid name others < /proc/$chart/stat\n"
      "[ \"$name\" = '(tektite)' ] && kill -INT $chart\nexit 1\n");
  const auto outcome =
      run_in(place.folder.path(), {place.folder.file("tektite"), "chart", "study.toml", "-o", "out", "--jobs", "1"});
  CHECK(outcome.code == 1);
  CHECK(outcome.faults == "tektite: error: interrupted; the same command goes on with what is missing\n");
  CHECK_THAT(outcome.output, !Contains("failed"));
}

TEST_CASE("Chart: where there is no Slurm it is told once, and nothing is run") {
  const Workplace place;
  const auto outcome = run_in(place.folder.path(), {"/usr/bin/env", "PATH=/nowhere", TEKTITE_PROGRAM, "chart",
                                                    "study.toml", "-o", "out", "--launcher", "slurm"});
  CHECK(outcome.code == 1);
  CHECK(outcome.faults ==
        "tektite: error: sbatch has submitted nothing: sbatch: cannot be started: No such file or directory\n");
  CHECK(fs::is_empty(place.folder.file("out/runs")));
}

TEST_CASE("Chart: what Slurm tells of tasks that are not as they should be is told, and nothing is run") {
  const Workplace place;
  const auto put = [&](const std::string& program, const std::string& script) {
    place.write(program, "#!/bin/sh\n" + script);
    fs::permissions(place.folder.file(program), fs::perms::owner_all);
  };
  const auto chart = [&] {
    return run_in(place.folder.path(), {"/usr/bin/env", "PATH=" + place.folder.path() + ":/usr/bin:/bin",
                                        TEKTITE_PROGRAM, "chart", "study.toml", "-o", "out", "--launcher", "slurm"});
  };
  put("sbatch", "echo 7\n");
  put("squeue", "exit 0\n");
  const auto unseen = chart();
  CHECK(unseen.code == 1);
  CHECK_THAT(unseen.faults, Contains("squeue does not show job 7, which sbatch has submitted"));
  CHECK(fs::is_empty(place.folder.file("out/runs")));

  // A task of an earlier study has a run of the same name.
  place.write("out/slurm/1.job", "7\n");
  place.write("out/runs/eulerian-2.task", "1 0 1\nanother scene");
  put("squeue", "echo 7 0 RUNNING\n");
  const auto taken = chart();
  CHECK(taken.code == 2);
  CHECK_THAT(taken.faults, Contains("eulerian-2: an earlier run of this name is task 7_0 of Slurm (allowed: `scancel "
                                    "7_0`, or to wait for its end)"));
  put("squeue", "echo 'squeue: error: nobody answers' >&2\nexit 1\n");
  const auto silent = chart();
  CHECK(silent.code == 1);
  CHECK(silent.faults == "tektite: error: squeue: nobody answers\n");
}

TEST_CASE("Chart: a wrong study is refused with its place before anything is run") {
  const Workplace place;
  const auto refused = [&](const std::string& old, const std::string& now) {
    auto wrong = study;
    wrong.replace(wrong.find(old), old.size(), now);
    place.write("study.toml", wrong);
    const auto outcome = place.chart();
    CHECK(outcome.code == 2);
    CHECK_FALSE(fs::exists(place.folder.file("out")));
    return outcome.faults;
  };
  CHECK_THAT(refused("target", "targt"), Contains("study.toml:4") && Contains("targt") && Contains("target"));
  CHECK_THAT(refused("title", "titel"), Contains("line.impossible.titel") && Contains("did you mean title?"));
  CHECK_THAT(refused("factor = 2", "factor = 0"), Contains("study.toml:3") && Contains("out of range"));
  CHECK_THAT(refused("factor = 2", "factor = 1"), Contains("stands twice"));
  CHECK_THAT(refused("factor = 2", "factors = 2"), Contains("resolutions[0]"));
  CHECK_THAT(refused("error_l1_pulse", "error_l1"), Contains("study.toml:6") && Contains("error_l1_pulse"));
  CHECK_THAT(refused("[line.viscous]", "[line.viscous]\nvariant = 'soft'"), Contains("no such variant"));
  CHECK_THAT(refused("name = \"tiny\"", "name = \"../tiny\""), Contains("names files, so it must be plain"));
  CHECK_THAT(refused("[line.viscous]", "[line.\"a b\"]"), Contains("line.a b") && Contains("so it must be plain"));
  CHECK_THAT(refused("scene.toml", "other.toml"), Contains("other.toml") && Contains("cannot be opened"));
  CHECK_THAT(place.chart({"study.toml", "--jobs", "0"}).faults, Contains("--jobs"));
  CHECK_THAT(place.chart({"study.toml", "--launcher", "pbs"}).faults, Contains("pbs") && Contains("local, slurm"));
  CHECK_THAT(place.chart({"study.toml", "--sbatch", "mem=4G"}).faults, Contains("--sbatch is for --launcher slurm"));
  CHECK_THAT(place.chart({"none.toml"}).faults, Contains("none.toml"));
  CHECK_THAT(refused(study.substr(study.find("[line.")), ""), Contains("there is nothing to run"));
  place.write("study.toml", study);
  CHECK_THAT(place.chart({"study.toml", "-o", "study.toml"}).faults, Contains("this is no folder"));
}

}  // namespace
