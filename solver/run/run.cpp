#include "run/run.hpp"

#include <fmt/format.h>
#include <omp.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/run_lock.hpp"
#include "core/snapshot_files.hpp"
#include "core/version.hpp"
#include "output/history.hpp"
#include "output/log.hpp"
#include "output/probes.hpp"
#include "output/progress.hpp"
#include "output/summary.hpp"
#include "run/simulation.hpp"

namespace tektite {
namespace {

namespace fs = std::filesystem;

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
  Run(const fs::path& folder, const Origin& origin, Snapshot snapshot, RunSettings settings)
      : folder_(folder),
        resumed_(origin.snapshot),
        simulation_(std::move(snapshot), std::move(settings), origin.snapshot),
        log_(open_log(folder_ / "run.log", origin.snapshot)),
        probes_(make_probes()),
        history_(make_history()) {
    log_->info("tektite {} on {}, {} threads: {} from {}", version, host(), omp_get_max_threads(),
               resumed_ ? "resumed" : "started", origin.file);
    const auto& particles = simulation_.particles();
    for (const auto& body : particles.bodies())
      log_->info("  {}: {} particles of {}, spacing {:g} m", body.name, body.range.size(), body.material, body.spacing);
    if (const auto remark = simulation_.scheme().remark(); !remark.empty()) log_->info("  {}", remark);
    if (!resumed_) {
      write_history();
      write_snapshot();
    } else {
      last_snapshot_ = origin.file;
      if (!simulation_.finished() && !snapshot_due()) stopgap_ = origin.file;
    }
  }

  bool to_the_end() {
    while (!simulation_.finished() && !interrupted) {
      simulation_.step();
      write_history();
      show_progress();
      if (snapshot_due() || simulation_.finished()) write_snapshot();
    }
    progress_.clear();
    if (!simulation_.finished()) write_snapshot();
    finish();
    return simulation_.finished();
  }

  /// What a failed run says beside its reason.
  std::string last_snapshot() const { return last_snapshot_; }

 private:
  Probes make_probes() {
    const auto& wanted = simulation_.settings().probes;
    return resumed_ ? Probes(wanted, simulation_.save({}).state) : Probes(wanted, simulation_.particles());
  }
  History make_history() {
    const auto path = (folder_ / "history.csv").string();
    if (resumed_) return History(path, simulation_.steps(), simulation_.settings().history_interval);
    const auto& particles = simulation_.particles();
    return History(path, particles.dimensions(), probes_.columns(particles));
  }

  /// A snapshot is due at the start, and in the first step at or behind each multiple of the interval.
  bool snapshot_due() const {
    if (simulation_.steps() == 0) return true;
    const double interval = simulation_.settings().snapshot_interval;
    const double before = simulation_.time() - simulation_.last_step().dt;
    return std::floor(simulation_.time() / interval) > std::floor(before / interval);
  }

  void write_snapshot() {
    std::map<std::string, double> state;
    probes_.save(state);
    history_.bring_to_disk();  // it must reach as far as the snapshot
    const auto path = snapshot_path(folder_, simulation_.steps());
    tektite::write_snapshot(simulation_.save(state), path);
    last_snapshot_ = path;
    if (!stopgap_.empty() && stopgap_ != last_snapshot_) fs::remove(stopgap_);
    stopgap_.clear();
    progress_.clear();
    log_->info("  t = {:<9} step {:<7} {}", shown_time(simulation_.time()), simulation_.steps(), last_snapshot_);
  }

  void write_history() {
    if (simulation_.steps() % simulation_.settings().history_interval != 0 && !simulation_.finished()) return;
    const auto& last = simulation_.last_step();
    ledger_ = simulation_.ledger();
    const auto& particles = simulation_.particles();
    const bool first = simulation_.steps() == 0;
    history_.write({simulation_.steps(), simulation_.time(), first ? 0.0 : last.dt,
                    first ? "start" : name_of(last.reason), particles.integers(Field::id)[last.particle], ledger_,
                    probes_.values(particles)});
  }

  void show_progress() {
    const auto& last = simulation_.last_step();
    progress_.show({simulation_.steps(), simulation_.time(), simulation_.end(), last.dt, name_of(last.reason),
                    simulation_.energy_drift(ledger_), simulation_.particles().count()});
  }

  void finish() {
    const auto summary = summarise(simulation_, timer_, !simulation_.finished());
    write_summary(summary, (folder_ / "solve.json").string());
    if (const auto remark = simulation_.scheme().closing_remark(); !remark.empty()) log_->info("  {}", remark);
    log_summary(summary, simulation_.profile(), *log_);
    if (!simulation_.finished())
      log_->info("interrupted at t = {}; go on with: tektite resume {}", shown_time(simulation_.time()),
                 folder_.string());
  }

  fs::path folder_;
  bool resumed_;
  RunTimer timer_;
  Simulation simulation_;
  std::shared_ptr<spdlog::logger> log_;
  Probes probes_;
  History history_;
  Progress progress_;
  Ledger ledger_;
  std::string last_snapshot_;  ///< that is whole
  std::string stopgap_;        ///< written because a run was interrupted: an unbroken run has none
};

RunSettings settings_of(const Snapshot& snapshot, const std::string& file, std::string& effective) {
  auto document = Document::parse(snapshot.scene, file + ":/scene");
  auto settings = read_run_settings(document);
  check_bodies(settings, snapshot.particles, file);
  if (snapshot.time() == 0.0) check_probes(document, settings, snapshot.particles);
  effective = document.text();
  return settings;
}

}  // namespace

bool run(const RunOptions& options) {
  if (options.threads > 0) omp_set_num_threads(options.threads);
  if (!fs::is_directory(options.folder))
    throw InputError({{options.folder, 0}, {}, {}, "there is no such folder", "the folder of a run"});
  const auto lock = options.lock < 0 ? std::make_unique<RunLock>(options.folder)
                                     : std::make_unique<RunLock>(options.folder, options.lock);
  const auto origin = find_origin(options);
  auto snapshot = read_snapshot(origin.file);
  auto settings = settings_of(snapshot, origin.file, snapshot.scene);
  remove_parts_of_snapshots(options.folder);
  if (!origin.snapshot)
    for (const auto& earlier : snapshot_files(options.folder)) fs::remove(earlier);
  watch_signals();
  Run run(options.folder, origin, std::move(snapshot), std::move(settings));
  try {
    return run.to_the_end();
  } catch (const RunError& fault) {
    throw RunError(fmt::format("{}\n  the last good snapshot is {}", fault.what(), run.last_snapshot()));
  }
}

void forecast(const std::string& particle_file, int threads) {
  if (threads > 0) omp_set_num_threads(threads);
  auto snapshot = read_snapshot(particle_file);
  auto settings = settings_of(snapshot, particle_file, snapshot.scene);
  Simulation simulation(std::move(snapshot), std::move(settings), false);
  std::optional<InputError> failure;
  try {
    print_forecast(simulation);
  } catch (const RunError& fault) {
    failure = InputError({{particle_file, 0}, {}, {}, fmt::format("the first steps fail: {}", fault.what()), {}});
  }
  if (failure) throw *failure;
}

}  // namespace tektite
