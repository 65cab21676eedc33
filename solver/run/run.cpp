#include "run/run.hpp"

#include <fmt/format.h>
#include <omp.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>

#include "core/version.hpp"
#include "output/history.hpp"
#include "output/log.hpp"
#include "output/probes.hpp"
#include "output/progress.hpp"
#include "output/summary.hpp"
#include "run/simulation.hpp"
#include "run/snapshots.hpp"

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

/// The run with everything that it writes.
class Run {
 public:
  Run(const RunOptions& options, const std::string& file, Snapshot snapshot, RunSettings settings)
      : folder_(options.folder),
        resumed_(options.resume),
        simulation_(std::move(snapshot), std::move(settings), options.resume),
        log_(open_log(folder_ / "run.log", options.resume)),
        probes_(make_probes()),
        history_(make_history()) {
    log_->info("tektite {} on {}, {} threads: {} from {}", version, host(), omp_get_max_threads(),
               resumed_ ? "resumed" : "started", file);
    const auto& particles = simulation_.particles();
    for (const auto& body : particles.bodies())
      log_->info("  {}: {} particles of {}, spacing {:g} m", body.name, body.range.size(), body.material, body.spacing);
    if (const auto remark = simulation_.scheme().remark(); !remark.empty()) log_->info("  {}", remark);
    if (!resumed_) {
      write_snapshot();
      write_history();
    }
  }

  bool to_the_end() {
    while (!simulation_.finished() && !interrupted) {
      simulation_.step();
      write_history();
      show_progress();
      if (snapshots_due() || simulation_.finished()) write_snapshot();
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
    if (resumed_) return History(path, simulation_.steps());
    const auto& particles = simulation_.particles();
    return History(path, particles.dimensions(), probes_.columns(particles));
  }

  /// A snapshot is due in the first step at or behind each multiple of the interval.
  bool snapshots_due() const {
    const double interval = simulation_.settings().snapshot_interval;
    const double before = simulation_.time() - simulation_.last_step().dt;
    return std::floor(simulation_.time() / interval) > std::floor(before / interval);
  }

  void write_snapshot() {
    std::map<std::string, double> state;
    probes_.save(state);
    last_snapshot_ = snapshot_path(folder_, simulation_.steps());
    tektite::write_snapshot(simulation_.save(state), last_snapshot_);
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
  std::string last_snapshot_;
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
  const auto file =
      options.resume ? newest_snapshot(options.folder) : (fs::path(options.folder) / "particles.h5").string();
  auto snapshot = read_snapshot(file);
  auto settings = settings_of(snapshot, file, snapshot.scene);
  if (!options.resume) remove_snapshots(options.folder);
  watch_signals();
  Run run(options, file, std::move(snapshot), std::move(settings));
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
  print_forecast(simulation);
}

}  // namespace tektite
