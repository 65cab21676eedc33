#include "run/recorded_run.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/sink.h>
#include <unistd.h>

#include <cmath>
#include <map>
#include <utility>

#include "core/counted.hpp"
#include "core/snapshot_files.hpp"
#include "core/version.hpp"
#include "parallel/distribution.hpp"
#include "parallel/reduce.hpp"
#include "parallel/threads.hpp"
#include "run/no_contact.hpp"

namespace tektite {
namespace {

namespace fs = std::filesystem;

std::string host() {
  char name[256] = "";
  ::gethostname(name, sizeof name - 1);
  return name;
}

/// Of the other ranks a log without a reader.
std::shared_ptr<spdlog::logger> log_in(const fs::path& folder, bool append) {
  return rank() == 0 ? open_log(folder / "run.log", append) : std::make_shared<spdlog::logger>("run");
}

}  // namespace

RecordedRun::RecordedRun(fs::path folder, Origin origin, const RunTimer& timer, Simulation& simulation, bool beyond,
                         std::function<bool()> interrupted)
    : folder_(std::move(folder)),
      origin_(std::move(origin)),
      timer_(timer),
      simulation_(simulation),
      interrupted_(std::move(interrupted)),
      log_(log_in(folder_, origin_.snapshot)),
      probes_(make_probes()),
      columns_(number_columns(simulation_.particles().space(), probes_.columns(simulation_.particles()))),
      stops_(make_stops()),
      watch_(origin_.snapshot ? Watch(simulation_.save({}).state) : Watch()),
      history_(make_history()) {
  begin(beyond);
}

Probes RecordedRun::make_probes() {
  const auto& wanted = simulation_.settings().probes;
  return origin_.snapshot ? Probes(wanted, simulation_.save({}).state) : Probes(wanted, simulation_.particles());
}

std::optional<History> RecordedRun::make_history() const {
  if (rank() > 0) return std::nullopt;
  const auto path = (folder_ / "history.csv").string();
  if (origin_.snapshot) return History(path, simulation_.steps(), simulation_.settings().history_interval);
  return History(path, columns_);
}

StopConditions RecordedRun::make_stops() {
  const auto& wanted = simulation_.settings().stops;
  return origin_.snapshot ? StopConditions(wanted, simulation_.save({}).state, columns_)
                          : StopConditions(wanted, simulation_.particles(), columns_);
}

void RecordedRun::begin(bool beyond) {
  log_->info("tektite {} on {}, {}{} threads: {} from {}", version, host(),
             ranks() > 1 ? fmt::format("{} ranks of ", ranks()) : "", threads_in_use(),
             origin_.snapshot ? "resumed" : "started", origin_.file);
  const auto& particles = simulation_.particles();
  for (const auto& body : particles.bodies())
    log_->info("  {}: {} of {}, spacing {:g} m", body.name, counted(size_of(particles, body), "particle"),
               body.material, body.spacing);
  if (ranks() > 1) {
    const auto [least, most] = least_and_most_owned(particles);
    log_->info("  each rank has {} to {} of them, and copies", least, most);
  }
  if (const auto remark = simulation_.scheme().remark(); !remark.empty()) log_->info("  {}", remark);
  if (!origin_.snapshot) {
    for (const auto& line : probes_.in_words(particles)) log_->info("  {}", line);
    write_history();
    write_snapshot();
    finish_snapshot();  // where it cannot be written nothing needs to be computed
  } else {
    last_snapshot_ = origin_.file;
    ledger_ = simulation_.ledger();  // what progress shows before the next line
    if (!over() && !snapshot_due() && !beyond) stopgap_ = origin_.file;
  }
}

bool RecordedRun::to_the_end() {
  try {
    return compute();
  } catch (const RunError& fault) {
    note(fault);
    settle();
    throw RunError(fmt::format("{}\n  the last good snapshot is {}", fault.what(), last_snapshot_));
  }
}

bool RecordedRun::compute() {
  bool ends_early = false;
  while (!over() && !(ends_early = interrupted_())) {
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
  if (ends_early) write_snapshot();
  finish_snapshot();
  finish();
  return over();
}

/// Before two of several bodies have met, everything is steady and nothing has been perforated.
bool RecordedRun::event_has_begun() const {
  return simulation_.particles().bodies().size() < 2 || simulation_.contact_time().has_value();
}

/// A snapshot is due at the start, and in the first step at or behind each multiple of the interval.
bool RecordedRun::snapshot_due() const {
  if (simulation_.steps() == 0) return true;
  const double interval = simulation_.settings().snapshot_interval;
  const double before = simulation_.time() - simulation_.last_step().dt;
  return std::floor(simulation_.time() / interval) > std::floor(before / interval);
}

/// Begins to; finish_snapshot() ends it.
void RecordedRun::write_snapshot() {
  finish_snapshot();
  std::map<std::string, double> state;
  probes_.save(state);
  stops_.save(state);
  watch_.save(state);
  begun_ = {snapshot_path(folder_, simulation_.steps()), simulation_.time(), simulation_.steps()};
  writer_.start(simulation_.save(state), begun_.path, history_ ? &*history_ : nullptr);
}

/// Waits for the snapshot that is being written, if there is one.
void RecordedRun::finish_snapshot() {
  if (!writer_.busy()) return;
  writer_.finish();
  last_snapshot_ = begun_.path;
  if (rank() == 0 && !stopgap_.empty() && stopgap_ != last_snapshot_) fs::remove(stopgap_);
  stopgap_.clear();
  progress_.clear();
  log_->info("  t = {:<9} step {:<7} {}", shown_time(begun_.time), begun_.step, begun_.path);
}

/// What a failed run waits for, before it is told which snapshot is the last.
void RecordedRun::settle() {
  try {
    finish_snapshot();
  } catch (const RunError& fault) {
    note(fault);
  }
}

/// Keeps the reason why a run failed in run.log; a disk that is full keeps nothing.
void RecordedRun::note(const RunError& fault) {
  if (rank() > 0) return;
  log_->sinks().front()->set_level(spdlog::level::off);  // whoever reads standard output is told by the error itself
  try {
    log_->error("{}", fault.what());
  } catch (const RunError&) {
  }
}

void RecordedRun::look() {
  simulation_.look([this](const Particles& particles) {
    tell(watch_.look(particles, simulation_.settings(), simulation_.scheme().warnings()));
  });
}

void RecordedRun::tell(const std::vector<Warning>& warnings) {
  if (!warnings.empty()) progress_.clear();
  for (const auto& warning : warnings) log_->warn("warning: {}: {}", warning.name, warning.text);
}

void RecordedRun::write_history() {
  if (simulation_.steps() % simulation_.settings().history_interval != 0 && !simulation_.finished()) return;
  const auto& last = simulation_.last_step();
  ledger_ = simulation_.ledger();
  simulation_.note(ledger_);
  const bool first = simulation_.steps() == 0;
  const auto numbers = numbers_of(ledger_, simulation_.angular_momentum(), probes_.values(simulation_.particles()));
  if (history_)
    history_->write({simulation_.steps(), simulation_.time(), first ? 0.0 : last.dt,
                     first ? "start" : name_of(last.reason), simulation_.limiting_particle(), numbers});
  if (event_has_begun()) stops_.look(simulation_.time(), simulation_.particles(), numbers);
}

void RecordedRun::show_progress() {
  const auto& last = simulation_.last_step();
  if (rank() > 0) return;
  progress_.show({simulation_.steps(), simulation_.time(), simulation_.end(), last.dt, name_of(last.reason),
                  simulation_.energy_drift(ledger_), simulation_.count()});
}

void RecordedRun::finish() {
  auto names = watch_.names();
  if (const auto warning = simulation_.finished() ? no_contact(simulation_) : std::nullopt) {
    tell({*warning});
    names.insert(warning->name);
  }
  auto summary = summarise(simulation_, timer_, !over(), std::move(names));
  if (const auto* stop = stops_.met()) summary.stopped_by = fmt::format("{}: {}", stop->name, in_words(*stop));
  if (rank() == 0) write_summary(summary, (folder_ / "solve.json").string());
  if (const auto remark = simulation_.scheme().closing_remark(); !remark.empty()) log_->info("  {}", remark);
  log_summary(summary, simulation_.profile(), *log_);
  if (!over())
    log_->info("interrupted at t = {}; go on with: tektite resume {}", shown_time(simulation_.time()),
               folder_.string());
}

}  // namespace tektite
