// Several ranks come to the bits of one process, wherever particles fly, and go on from each other's snapshots.
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <limits>
#include <regex>
#include <sstream>

#include "core/snapshot.hpp"
#include "robustness/on_ranks.hpp"
#include "robustness/small_run.hpp"

namespace {

namespace fs = std::filesystem;
using namespace tektite::test;
using Catch::Matchers::Contains;

/// What a run on so many ranks leaves, beside that of one process.
void check_ranks(const SmallRun& small, const Left& whole, int ranks) {
  INFO(ranks << " ranks");
  const auto run = "ranks" + std::to_string(ranks);
  small.fill(run);
  const auto outcome = small.program(on_ranks(ranks, small.solving(run)));
  INFO(outcome.output << outcome.faults);
  REQUIRE(outcome.code == 0);
  small.measure(run);
  const auto left = left_in(small.folder(run));
  CHECK(left.snapshots == whole.snapshots);
  CHECK((left.history == whole.history));
  CHECK((left.last_snapshot == whole.last_snapshot));
  CHECK(left.measurements == whole.measurements);
  const auto log = content_of(small.folder(run + "/run.log"));
  CHECK_THAT(log, Contains(std::to_string(ranks) + " ranks of 1 threads") && Contains("messages to other ranks"));
}

/// The processes that this one has started.
std::vector<pid_t> children_of(pid_t parent) {
  std::vector<pid_t> children;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "stat");
    std::string number, rest;
    if (!(file >> number) || !std::getline(file, rest)) continue;
    std::istringstream behind_name(rest.substr(rest.rfind(')') + 1));
    char state = ' ';
    pid_t ppid = 0;
    if (behind_name >> state >> ppid && ppid == parent) children.push_back(std::stoi(number));
  }
  return children;
}

TEST_CASE("Ranks: two, three, four and seven give the bits of one process") {
  const SmallRun small("eulerian", {"output.history=2",
                                    "stop_when.steady={column='centre.pressure', during='2.9 us', "
                                    "tolerance=1e-9}"});
  const auto whole = small.unbroken();
  for (const int ranks : {2, 3, 4, 7}) check_ranks(small, whole, ranks);
}

TEST_CASE("Ranks: every scheme that is offered on several gives the bits of one process") {
  const auto settings = GENERATE(values<std::vector<std::string>>(
      {{"scheme={type='eulerian', correction='mixed', correction_limit=10.0}", "symmetry.middle={axis='y'}",
        "body.bar.shape.lower=['-16.5 mm', 0]", "body.plate.shape.lower=['0.5 mm', 0]"},
       {"scheme={type='eulerian', artificial_stress={}}"},
       {"scheme.type='eulerian'", "space='plane-stress'"},
       {"scheme.type='godunov-pm'"},
       {"scheme={type='godunov-split', correction='mixed'}"}}));
  INFO(settings.front());
  const SmallRun small("eulerian", settings);
  check_ranks(small, small.unbroken(), 3);
}

TEST_CASE("Ranks: a total-Lagrangian bar on an anvil, on a lattice and by lists, has the bits of one process") {
  const auto settings = GENERATE(
      values<std::vector<std::string>>({{"scheme.hourglass_control=0.02"},
                                        {"space='axisymmetric'"},
                                        {"scheme.correction='none'", "body.bar.arrangement={type='hexagonal'}"}}));
  INFO(settings.front());
  const SmallRun small("total-lagrangian", settings);
  std::ofstream(small.folder("scene.toml")) << R"(
name = "bar"
space = "plane-strain"
spacing = "0.5 mm"
scheme.type = "total-lagrangian"
anvil.axis = "y"
time.end = "3 us"
output.snapshots = "0.3 us"
)" << small_material << R"(
[body.bar]
material = "aluminium"
shape = { type = "rectangle", lower = [0, 0], upper = ["6 mm", "12 mm"] }
velocity = [0, "-400 m/s"]
)";
  check_ranks(small, small.unbroken(), 3);
}

TEST_CASE("Ranks: bodies in contact, apart, in touch and in pieces, have the bits of one process") {
  const auto [scheme, settings] = GENERATE(table<std::string, std::vector<std::string>>(
      {{"eulerian", {"contact.model='kernel-penalty'"}},
       // Four bodies in touch and a wall, so that a particle has sums with two others.
       {"eulerian",
        {"contact.begins='at-faces'", "symmetry.middle={axis='y'}", "body.bar.shape.lower=['-16.5 mm', 0]",
         "body.plate.shape={type='rectangle', lower=['0.5 mm', 0], upper=['4.5 mm', '7 mm']}",
         "body.upper={material='aluminium', shape={type='rectangle', lower=['0.5 mm', '7 mm'], "
         "upper=['4.5 mm', '15 mm']}}",
         "body.rear={material='aluminium', shape={type='rectangle', lower=['4.5 mm', 0], "
         "upper=['8.5 mm', '15 mm']}}"}},
       {"godunov-pm", {"contact.model='kernel-penalty'"}},
       {"godunov-split", {"contact.begins='at-faces'"}},
       {"total-lagrangian", {"contact.itself=true"}}}));
  INFO(scheme << " " << settings.front());
  const SmallRun small(scheme, settings);
  const auto whole = small.unbroken();
  for (const int ranks : {2, 7}) check_ranks(small, whole, ranks);
}

TEST_CASE("Ranks: adaptle turns the same particles Eulerian as one process, by strain, by damage and in a patch") {
  const std::string damage =
      "material.aluminium.damage={model='johnson-cook', d1=0.05, d2=0.0, d3=0.0, d4=0.0, d5=0.0}";
  const auto settings = GENERATE_COPY(values<std::vector<std::string>>(
      {{"scheme={type='adaptle', conversion='strain', conversion_strain=0.1, correction='none', "
        "artificial_stress={interface='both'}}"},
       // Failed particles leave the sums, and turn Eulerian with their neighbours, one after the other.
       {"scheme={type='adaptle', conversion='strain', conversion_strain=0.15}", damage},
       {"scheme={type='adaptle', conversion='damage', correction='mixed'}", damage, "contact.itself=true"},
       {"scheme={type='adaptle', conversion='none'}",
        "body.plate.region.patch={kernel='eulerian', shape={type='rectangle', lower=['0.5 mm', '-6 mm'], "
        "upper=['8.5 mm', '6 mm']}}"}}));
  INFO(settings.front());
  const SmallRun small("total-lagrangian", settings);
  const auto whole = small.unbroken();
  for (const int ranks : {3, 7}) check_ranks(small, whole, ranks);
}

TEST_CASE("Ranks: what total-Lagrangian particles that fail leave behind has the bits of one process") {
  const SmallRun small("total-lagrangian",
                       {"material.aluminium.damage={model='johnson-cook', d1=0.05, d2=0.0, d3=0.0, d4=0.0, d5=0.0}"});
  const auto whole = small.unbroken();
  for (const int ranks : {3, 7}) check_ranks(small, whole, ranks);
}

TEST_CASE("Ranks: msph, ssph and steps that search in their midst give the bits of one process") {
  const auto [scheme, settings] = GENERATE(table<std::string, std::vector<std::string>>(
      {{"msph", {"time.end='1 us'"}},
       {"msph", {"time.end='1 us'", "scheme={type='ssph', forces='adjoint'}"}},
       {"godunov-split",
        {"scheme={type='godunov-split', splitting='strang'}", "contact.model='kernel-penalty'",
         "time.from='contact'"}}}));
  INFO(scheme << " " << settings.back());
  const SmallRun small(scheme, settings);
  check_ranks(small, small.unbroken(), 3);
}

TEST_CASE("Ranks: rings about an axis, and shells about a centre, have the bits of one process") {
  const std::vector<std::string> rings{
      "space='axisymmetric'", "probe.centre.position=[0, '-5 mm']", "time.end='1 us'",
      "body.bar={material='aluminium', velocity=[0, '800 m/s'], shape={type='rectangle', lower=[0, '-16.5 mm'], "
      "upper=['5 mm', '-0.5 mm']}}"};
  const std::string plate =
      "body.plate={material='aluminium', shape={type='rectangle', lower=[0, '0.5 mm'], upper=['15 mm', '8.5 mm']}}";
  const auto [scheme, more] = GENERATE_COPY(table<std::string, std::vector<std::string>>(
      {{"eulerian", {plate}},
       {"eulerian", {plate, "scheme={type='eulerian', correction='mixed'}"}},
       {"msph", {plate}},
       {"msph", {plate, "scheme={type='msph', forces='adjoint'}"}}}));
  auto settings = rings;
  settings.insert(settings.end(), more.begin(), more.end());
  INFO(scheme << " " << more.front());
  const SmallRun small(scheme, settings);
  check_ranks(small, small.unbroken(), 3);
}

TEST_CASE("Ranks: more of them than particles, and a body that flies out of the others' reach") {
  const SmallRun few("eulerian", {"spacing='8 mm'"});
  check_ranks(few, few.unbroken(), 7);
  const SmallRun far("eulerian", {"body.bar.velocity=['-30 km/s', '10 km/s']"});
  check_ranks(far, far.unbroken(), 3);
}

TEST_CASE("Ranks: one that dies ends the run, and other numbers of ranks go on from its snapshot") {
  const SmallRun small("eulerian");
  const auto whole = small.unbroken();
  small.fill("killed");
  auto running = small.start(on_ranks(3, small.solving("killed")));
  REQUIRE(comes_about([&] { return tektite::snapshot_files(small.folder("killed")).size() >= 4; }));
  const auto processes = children_of(running.process());
  REQUIRE(processes.size() == 3);
  ::kill(processes.back(), SIGKILL);
  CHECK(running.wait() != 0);
  REQUIRE(tektite::snapshot_files(small.folder("killed")).size() < whole.snapshots.size());
  fs::copy(small.folder("killed"), small.folder("alone"), fs::copy_options::recursive);
  for (const auto& [run, words] :
       {std::pair("killed", on_ranks(2, small.resuming("killed"))), std::pair("alone", small.resuming("alone"))}) {
    const auto outcome = small.program(words);
    INFO(outcome.output << outcome.faults);
    REQUIRE(outcome.code == 0);
    small.measure(run);
    CHECK((left_in(small.folder(run)) == whole));
  }
}

TEST_CASE("Ranks: what is wrong is told once, whichever of them finds it") {
  const SmallRun small("eulerian");
  const auto missing = small.program(on_ranks(2, small.solving("missing")));
  CHECK(missing.code == 2);
  CHECK(count_of("there is no such folder", missing.faults) == 1);
  const auto with = [&](std::initializer_list<std::string> options) {
    auto words = small.solving("missing");
    words.insert(words.end(), options);
    return small.program(on_ranks(2, words));
  };
  const auto wrong = with({"--end", "1s"});
  CHECK(wrong.code == 2);
  CHECK(count_of("--end goes with --resume", wrong.faults) == 1);
  CHECK(count_of("Usage", with({"--help"}).output) == 1);

  // The last rank alone reads the last row.
  small.fill("broken");
  auto snapshot = tektite::read_snapshot(small.folder("broken/particles.h5"));
  snapshot.particles.reals(tektite::Field::velocity).back() = std::numeric_limits<double>::quiet_NaN();
  tektite::write_snapshot(snapshot, small.folder("broken/particles.h5"));
  const auto broken = small.program(on_ranks(3, small.solving("broken")));
  CHECK(broken.code == 2);
  CHECK(count_of("broken/particles.h5: /particles/velocity: holds a number that is not finite", broken.faults) == 1);

  // All come to it.
  const SmallRun parting("eulerian",
                         {"time.from='contact'", "time.end='0.1 us'", "body.bar.shape.upper=['-6.5 mm', '5 mm']",
                          "probe.centre.position=['-10 mm', 0]"});
  parting.fill("alone");
  const auto alone = parting.program(on_ranks(3, parting.solving("alone")));
  CHECK(alone.code == 1);
  CHECK(count_of("none has come in as long a time", alone.faults) == 1);
}

TEST_CASE("Ranks: where a snapshot has no room on the disk the run ends, and no half of it is left") {
  constexpr auto limit = [] {
    constexpr rlim_t room = 9 << 20;  // enough for what the launcher writes
    const rlimit limits{room, room};
    ::setrlimit(RLIMIT_FSIZE, &limits);
  };
  const SmallRun small("eulerian", {"spacing='0.09 mm'"});
  small.fill("full");
  const auto outcome = run_in(small.path(), on_ranks(3, small.solving("full")), limit);
  CHECK(outcome.code == 1);
  CHECK(count_of("full/snapshots/000000.h5: there is no room for it", outcome.faults) == 1);
  CHECK(fs::is_empty(small.folder("full/snapshots")));
}

TEST_CASE("Ranks: each gets as many particles as the others") {
  const SmallRun small("eulerian", {"spacing='0.5 mm'", "time.end='0.1 us'"});
  for (const int ranks : {2, 3, 7}) {
    const auto run = "dealt" + std::to_string(ranks);
    small.fill(run);
    REQUIRE(small.program(on_ranks(ranks, small.solving(run))).code == 0);
    std::smatch found;
    const auto log = content_of(small.folder(run + "/run.log"));
    REQUIRE(std::regex_search(log, found, std::regex("each rank has ([0-9]+) to ([0-9]+) of them")));
    CHECK(std::stod(found[2]) <= 1.1 * std::stod(found[1]));
  }
}

}  // namespace
