#include "run/run.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/sink.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

#include "advice/print.hpp"
#include "core/run_lock.hpp"
#include "core/saved_number.hpp"
#include "core/snapshot_files.hpp"
#include "core/version.hpp"
#include "core/write_beside.hpp"
#include "output/history.hpp"
#include "output/log.hpp"
#include "output/probes.hpp"
#include "output/progress.hpp"
#include "output/snapshot_writer.hpp"
#include "output/summary.hpp"
#include "parallel/ranks.hpp"
#include "parallel/shared_snapshot.hpp"
#include "parallel/threads.hpp"
#include "run/floating_point_traps.hpp"
#include "run/no_contact.hpp"
#include "run/simulation.hpp"
#include "run/watch.hpp"

namespace tektite {
namespace {

namespace fs = std::filesystem;

/// Processor time that `tektite check` spends on steps to measure what they cost.
constexpr double calibration_seconds = 0.5;

std::atomic<bool> interrupted = false;

void watch_signals() {
  interrupted = false;
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted = true; };
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

std::string host() {
  char name[256] = "";
  ::gethostname(name, sizeof name - 1);
  return name;
}

/// What a run starts from: its particles, or a snapshot.
struct Origin {
  std::string file;
  bool snapshot = false;
};

/// Throws InputError where there is nothing to resume.
Origin find_origin(const RunOptions& options) {
  const fs::path folder(options.folder);
  const auto particles = (folder / "particles.h5").string();
  if (!options.resume) return {particles, false};
  if (const auto snapshots = snapshot_files(folder); !snapshots.empty()) return {snapshots.back(), true};
  if (fs::exists(particles)) return {particles, false};
  throw InputError(
      {{options.folder, 0}, {}, {}, "there is no snapshot to go on from", "the folder of a run that was started"});
}

/// The run with everything that it writes.
class Run {
 public:
  /// Who goes on with a run `beyond` its end keeps the snapshot of that.
  Run(const fs::path& folder, const Origin& origin, const RunTimer& timer, Simulation& simulation, bool beyond)
      : folder_(folder),
        resumed_(origin.snapshot),
        timer_(timer),
        simulation_(simulation),
        log_(open_log(folder_ / "run.log", origin.snapshot)),
        probes_(make_probes()),
        columns_(number_columns(simulation_.particles().space(), probes_.columns(simulation_.particles()))),
        stops_(make_stops()),
        watch_(resumed_ ? Watch(simulation_.save({}).state) : Watch()),
        history_(make_history()) {
    log_->info("tektite {} on {}, {}{} threads: {} from {}", version, host(),
               ranks() > 1 ? fmt::format("{} ranks of ", ranks()) : "", threads_in_use(),
               resumed_ ? "resumed" : "started", origin.file);
    const auto& particles = simulation_.whole();
    for (const auto& body : particles.bodies())
      log_->info("  {}: {} particles of {}, spacing {:g} m", body.name, body.range.size(), body.material, body.spacing);
    if (const auto remark = simulation_.remark(); !remark.empty()) log_->info("  {}", remark);
    if (!resumed_) {
      for (const auto& line : probes_.in_words(particles)) log_->info("  {}", line);
      write_history();
      write_snapshot();
      finish_snapshot();  // where it cannot be written nothing needs to be computed
    } else {
      last_snapshot_ = origin.file;
      ledger_ = simulation_.ledger();  // what progress shows before the next line
      if (!over() && !snapshot_due() && !beyond) stopgap_ = origin.file;
    }
  }

  bool to_the_end() {
    while (!over() && !interrupted) {
      simulation_.step();
      write_history();
      show_progress();
      if (writer_.busy() && !writer_.at_work()) finish_snapshot();
      if (snapshot_due() || over()) {
        look();  // before the snapshot, which keeps what has been told
        write_snapshot();
      }
    }
    progress_.clear();
    if (!over()) write_snapshot();
    finish_snapshot();
    finish();
    return over();
  }

  /// What a failed run waits for, before it is told which snapshot is the last.
  void settle() {
    try {
      finish_snapshot();
    } catch (const RunError& fault) {
      note(fault);
    }
  }

  /// Keeps the reason why a run failed in run.log; a disk that is full keeps nothing.
  void note(const RunError& fault) {
    log_->sinks().front()->set_level(spdlog::level::off);  // whoever reads standard output is told by the error itself
    try {
      log_->error("{}", fault.what());
    } catch (const RunError&) {
    }
  }

  /// What a failed run says beside its reason.
  std::string last_snapshot() const { return last_snapshot_; }

 private:
  Probes make_probes() {
    const auto& wanted = simulation_.settings().probes;
    return resumed_ ? Probes(wanted, simulation_.save({}).state) : Probes(wanted, simulation_.whole());
  }
  History make_history() {
    const auto path = (folder_ / "history.csv").string();
    if (resumed_) return History(path, simulation_.steps(), simulation_.settings().history_interval);
    return History(path, columns_);
  }
  StopConditions make_stops() {
    const auto& wanted = simulation_.settings().stops;
    return resumed_ ? StopConditions(wanted, simulation_.save({}).state, columns_)
                    : StopConditions(wanted, simulation_.whole(), columns_);
  }

  /// At its end, or stopped by a condition.
  bool over() const { return simulation_.finished() || stops_.met(); }

  /// Before two of several bodies have met, everything is steady and nothing has been perforated.
  bool event_has_begun() const {
    return simulation_.particles().bodies().size() < 2 || simulation_.contact_time().has_value();
  }

  /// A snapshot is due at the start, and in the first step at or behind each multiple of the interval.
  bool snapshot_due() const {
    if (simulation_.steps() == 0) return true;
    const double interval = simulation_.settings().snapshot_interval;
    const double before = simulation_.time() - simulation_.last_step().dt;
    return std::floor(simulation_.time() / interval) > std::floor(before / interval);
  }

  /// Begins to; finish_snapshot() ends it.
  void write_snapshot() {
    finish_snapshot();
    std::map<std::string, double> state;
    probes_.save(state);
    stops_.save(state);
    watch_.save(state);
    begun_ = {snapshot_path(folder_, simulation_.steps()), simulation_.time(), simulation_.steps()};
    writer_.start(simulation_.save(state), begun_.path, history_);
  }

  /// Waits for the snapshot that is being written, if there is one.
  void finish_snapshot() {
    if (!writer_.busy()) return;
    writer_.finish();
    last_snapshot_ = begun_.path;
    if (!stopgap_.empty() && stopgap_ != last_snapshot_) fs::remove(stopgap_);
    stopgap_.clear();
    progress_.clear();
    log_->info("  t = {:<9} step {:<7} {}", shown_time(begun_.time), begun_.step, begun_.path);
  }

  void look() { tell(watch_.look(simulation_.whole(), simulation_.settings(), simulation_.warnings())); }

  void tell(const std::vector<Warning>& warnings) {
    if (!warnings.empty()) progress_.clear();
    for (const auto& warning : warnings) log_->warn("warning: {}: {}", warning.name, warning.text);
  }

  void write_history() {
    if (simulation_.steps() % simulation_.settings().history_interval != 0 && !simulation_.finished()) return;
    const auto& last = simulation_.last_step();
    ledger_ = simulation_.ledger();
    simulation_.note(ledger_);
    const auto& settings = simulation_.settings();
    const bool looked_at = !settings.probes.empty() || !settings.stops.empty();  // all particles, on the first rank
    const auto& particles = looked_at ? simulation_.whole() : simulation_.particles();
    const bool first = simulation_.steps() == 0;
    const auto numbers = numbers_of(ledger_, simulation_.angular_momentum(), probes_.values(particles));
    history_.write({simulation_.steps(), simulation_.time(), first ? 0.0 : last.dt,
                    first ? "start" : name_of(last.reason), simulation_.limiting_particle(), numbers});
    if (event_has_begun()) stops_.look(simulation_.time(), particles, numbers);
  }

  void show_progress() {
    const auto& last = simulation_.last_step();
    progress_.show({simulation_.steps(), simulation_.time(), simulation_.end(), last.dt, name_of(last.reason),
                    simulation_.energy_drift(ledger_), simulation_.count()});
  }

  void finish() {
    auto names = watch_.names();
    if (const auto warning = simulation_.finished() ? no_contact(simulation_) : std::nullopt) {
      tell({*warning});
      names.insert(warning->name);
    }
    auto summary = summarise(simulation_, timer_, !over(), std::move(names));
    if (const auto* stop = stops_.met()) summary.stopped_by = fmt::format("{}: {}", stop->name, in_words(*stop));
    write_summary(summary, (folder_ / "solve.json").string());
    if (const auto remark = simulation_.scheme().closing_remark(); !remark.empty()) log_->info("  {}", remark);
    log_summary(summary, simulation_.profile(), *log_);
    if (!over())
      log_->info("interrupted at t = {}; go on with: tektite resume {}", shown_time(simulation_.time()),
                 folder_.string());
  }

  fs::path folder_;
  bool resumed_;
  RunTimer timer_;
  Simulation& simulation_;
  std::shared_ptr<spdlog::logger> log_;
  Probes probes_;
  std::vector<std::string> columns_;  ///< of a line's numbers
  StopConditions stops_;
  Watch watch_;
  History history_;
  Progress progress_;
  Ledger ledger_;
  std::string last_snapshot_;  ///< that is whole
  std::string stopgap_;        ///< written because a run was interrupted: an unbroken run has none
  struct {
    std::string path;
    double time;
    std::int64_t step;
  } begun_;                ///< what is being written
  SnapshotWriter writer_;  ///< stands last: it is waited for before anything else goes
};

Document scene_of(const Snapshot& snapshot, const std::string& file) {
  return Document::parse(snapshot.scene, file + ":/scene");
}

/// What the solver reads of the scene; afterwards `document` is the effective one.
RunSettings settings_of(const Snapshot& snapshot, const std::string& file, Document& document) {
  auto settings = read_run_settings(document);
  check_bodies(settings, snapshot.particles, file);
  if (snapshot.time() == 0.0) {
    const auto& particles = snapshot.particles;
    check_anvil(document, settings, particles);
    check_probes(document, settings, particles);
    const auto probe_columns = Probes(settings.probes, particles).columns(particles);
    check_stop_conditions(document, settings.stops, particles, number_columns(particles.space(), probe_columns));
  }
  return settings;
}

/// Throws InputError where the run is beyond its new end already.
void check_end(const Simulation& simulation, const RunOptions& options) {
  if (simulation.time() > simulation.end())
    throw InputError({{"--end " + options.end, 0},
                      {},
                      {},
                      fmt::format("the newest snapshot is at t = {}", shown_time(simulation.time())),
                      "a later time"});
}

/// True where the run came to its end; a failure is kept in its log.
bool end_of(Run& run) {
  try {
    return run.to_the_end();
  } catch (const RunError& fault) {
    run.note(fault);
    run.settle();
    throw RunError(fmt::format("{}\n  the last good snapshot is {}", fault.what(), run.last_snapshot()));
  }
}

/// Gives the others what they need, or, on them, takes it: whether the run is resumed.
bool share(Snapshot& snapshot, bool resumed) {
  if (ranks() == 1) return resumed;
  share_snapshot(snapshot);
  return from_first_rank({resumed ? Word{1} : Word{0}}).front() != 0;
}

/// The run of a scene from its start. A scheme that refuses what the scene asks for names the key and not the file.
std::unique_ptr<Simulation> simulation_of(Snapshot snapshot, RunSettings settings, bool resumed, Document& document) {
  if (resumed) return std::make_unique<Simulation>(std::move(snapshot), std::move(settings), true);
  try {
    return std::make_unique<Simulation>(std::move(snapshot), std::move(settings), false);
  } catch (const InputError& error) {
    throw document.root().fault("", error.what(), "");
  }
}

/// A rank beside the first one: it has no files, says nothing, and is ended by the first one alone.
bool follow(const RunOptions& options) {
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  Snapshot snapshot;
  const bool resumed = share(snapshot, false);
  use_threads(options.threads, std::numeric_limits<std::size_t>::max());
  if (options.trap_floating_point) trap_floating_point();
  auto document = scene_of(snapshot, options.folder);
  auto settings = read_run_settings(document);
  try {
    Simulation simulation(std::move(snapshot), std::move(settings), resumed);
    simulation.follow();
  } catch (const InputError&) {
    from_first_rank({});  // which comes to it too, tells it, and ends all
  } catch (const RunError&) {
    from_first_rank({});
  }
  return true;
}

}  // namespace

bool run(const RunOptions& options) {
  if (rank() > 0) return follow(options);
  if (!fs::is_directory(options.folder))
    throw InputError({{options.folder, 0}, {}, {}, "there is no such folder", "the folder of a run"});
  const auto lock = options.lock < 0 ? std::make_unique<RunLock>(options.folder)
                                     : std::make_unique<RunLock>(options.folder, options.lock);
  const auto origin = find_origin(options);
  auto snapshot = read_snapshot(origin.file);
  use_threads(options.threads, snapshot.particles.count() / static_cast<std::size_t>(ranks()));
  auto document = scene_of(snapshot, origin.file);
  if (!options.end.empty()) document.set("time.end=" + options.end, "--end " + options.end);
  auto settings = settings_of(snapshot, origin.file, document);
  snapshot.scene = document.text();
  remove_parts_of_snapshots(options.folder);
  if (!origin.snapshot)
    for (const auto& earlier : snapshot_files(options.folder)) fs::remove(earlier);
  watch_signals();
  if (options.trap_floating_point) trap_floating_point();
  const RunTimer timer;
  share(snapshot, origin.snapshot);
  try {
    const auto made = simulation_of(std::move(snapshot), std::move(settings), origin.snapshot, document);
    auto& simulation = *made;
    check_probed_fields(document, simulation.settings(), simulation.particles());
    if (!options.end.empty()) check_end(simulation, options);
    Run run(options.folder, origin, timer, simulation, !options.end.empty());
    const bool over = end_of(run);
    simulation.dismiss();
    return over;
  } catch (const MissingNumber& missing) {
    throw InputError({{origin.file, 0}, missing.what(), {}, "is missing", "a snapshot of this scene, whole"});
  }
}

void check(const CheckOptions& options) {
  auto snapshot = read_snapshot(options.particles);
  use_threads(options.threads, snapshot.particles.count());
  auto document = scene_of(snapshot, options.particles);
  auto settings = settings_of(snapshot, options.particles, document);
  const auto met = meetings(snapshot.particles, settings.materials);
  Advice advice;
  if (options.advice) advice = advise(snapshot.particles, settings, met, document);
  const auto made = simulation_of(std::move(snapshot), std::move(settings), false, document);
  auto& simulation = *made;
  check_probed_fields(document, simulation.settings(), simulation.particles());
  std::optional<InputError> failure;
  try {
    print_scene(simulation);
    for (const auto& line :
         Probes(simulation.settings().probes, simulation.particles()).in_words(simulation.particles()))
      fmt::print("{}\n", line);
    print(forecast_of(simulation, met, options.advice ? calibration_seconds : 0.0), simulation);
  } catch (const RunError& fault) {
    failure = InputError({{options.particles, 0}, {}, {}, fmt::format("the first steps fail: {}", fault.what()), {}});
  }
  if (failure) throw *failure;
  if (!options.advice) return;
  print(advice);
  write_text_beside(*options.advice, fmt::format("{}\n", fmt::join(advice.settings, "\n")));
}

}  // namespace tektite
