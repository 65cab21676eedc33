#include "output/summary.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "core/version.hpp"
#include "core/write_beside.hpp"
#include "output/progress.hpp"
#include "parallel/ranks.hpp"
#include "parallel/threads.hpp"
#include "parallel/traffic.hpp"

namespace tektite {
namespace {

/// Of the energy, and of what turns: the published runs of these schemes stay below it (README.md of the examples).
constexpr double notable_drift = 0.01;

/// What the first rank had to do with the others.
void log_traffic(const RunSummary& s, spdlog::logger& log) {
  if (ranks() == 1) return;
  const auto& sent = traffic();
  const auto a_step = [&](std::size_t number) {
    return static_cast<double>(number) / static_cast<double>(std::max<std::int64_t>(s.steps_taken, 1));
  };
  log.info(
      "  {:.2f} s, {:.1f} % of the run, with messages to other ranks and waiting: {:.0f} a step, of {:.1f} kB in all",
      sent.seconds, 100.0 * sent.seconds / s.wall_seconds, a_step(sent.messages), 1e-3 * a_step(sent.bytes));
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

std::size_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

RunTimer::RunTimer() : wall_(std::chrono::steady_clock::now()), cpu_(processor_seconds()) {}

double RunTimer::wall_seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
}

double RunTimer::cpu_seconds() const { return processor_seconds() - cpu_; }

RunSummary summarise(const Simulation& simulation, const RunTimer& timer, bool interrupted,
                     std::set<std::string> warnings) {
  RunSummary summary;
  const auto& particles = simulation.particles();
  summary.scheme = simulation.settings().scheme.type;
  summary.particles = simulation.count();
  summary.steps = simulation.steps();
  summary.steps_taken = simulation.steps_taken();
  summary.time = simulation.time();
  summary.contact_time = simulation.contact_time();
  summary.threads = threads_in_use();
  summary.wall_seconds = timer.wall_seconds();
  summary.cpu_seconds = timer.cpu_seconds();
  double computing = 0.0;
  for (const auto& [name, seconds] : simulation.profile().seconds()) computing += seconds;
  const double particle_steps = static_cast<double>(simulation.steps_taken()) * static_cast<double>(simulation.count());
  summary.particle_steps_per_second = computing > 0.0 ? particle_steps / computing : 0.0;  // a run may be over already
  summary.peak_memory_bytes = peak_memory();
  summary.bytes_per_particle =
      (particles.memory() + simulation.scheme().memory()) / std::max<std::size_t>(particles.count(), 1);
  const auto ledger = simulation.ledger();
  summary.energy_drift = simulation.energy_drift(ledger);
  summary.momentum_drift = simulation.momentum_drift(ledger);
  summary.angular_momentum_drift = simulation.angular_momentum_drift();
  summary.interrupted = interrupted;
  summary.warnings = std::move(warnings);
  if (std::abs(summary.energy_drift) > notable_drift) summary.warnings.insert("energy-drift");
  if (summary.angular_momentum_drift > notable_drift) summary.warnings.insert("spin-drift");
  return summary;
}

void write_summary(const RunSummary& s, const std::string& path) {
  std::string warnings;
  for (const auto& name : s.warnings) warnings += fmt::format("{}\"{}\"", warnings.empty() ? "" : ", ", name);
  const auto contact = s.contact_time ? fmt::format("  \"contact_time\": {},\n", *s.contact_time) : std::string();
  const auto turned = s.angular_momentum_drift
                          ? fmt::format("  \"angular_momentum_drift\": {},\n", *s.angular_momentum_drift)
                          : std::string();
  const auto stopped = s.stopped_by.empty() ? std::string() : fmt::format("  \"stopped_by\": \"{}\",\n", s.stopped_by);
  write_text_beside(
      path, fmt::format("{{\n  \"version\": \"{}\",\n  \"scheme\": \"{}\",\n  \"particles\": {},\n  \"steps\": {},\n"
                        "  \"time\": {},\n{}  \"threads\": {},\n  \"wall_seconds\": {},\n  \"cpu_seconds\": {},\n"
                        "  \"particle_steps_per_second\": {},\n  \"peak_memory_bytes\": {},\n"
                        "  \"bytes_per_particle\": {},\n  \"energy_drift\": {},\n  \"momentum_drift\": {},\n"
                        "{}{}  \"interrupted\": {},\n  \"warnings\": [{}]\n}}\n",
                        version, s.scheme, s.particles, s.steps, s.time, contact, s.threads, s.wall_seconds,
                        s.cpu_seconds, s.particle_steps_per_second, s.peak_memory_bytes, s.bytes_per_particle,
                        s.energy_drift, s.momentum_drift, turned, stopped, s.interrupted, warnings));
}

void log_summary(const RunSummary& s, const Profile& profile, spdlog::logger& log) {
  log.info("{} steps to t = {} in {:.1f} s ({:.1f} s of processor time)", s.steps, shown_time(s.time), s.wall_seconds,
           s.cpu_seconds);
  if (!s.stopped_by.empty()) log.info("  stopped by {}", s.stopped_by);
  log.info("  {:.2f} million particle-steps per second on {} threads, {} bytes a particle, peak memory {:.0f} MB",
           1e-6 * s.particle_steps_per_second, s.threads, s.bytes_per_particle,
           1e-6 * static_cast<double>(s.peak_memory_bytes));
  log.info("  energy drift {:+.3e}, momentum drift {:.1e}{}", s.energy_drift, s.momentum_drift,
           s.angular_momentum_drift ? fmt::format(", angular momentum drift {:.1e}", *s.angular_momentum_drift) : "");
  double all = 0.0;
  for (const auto& [name, seconds] : profile.seconds()) all += seconds;
  for (const auto& [name, seconds] : profile.seconds())
    log.info("  {:<12} {:7.2f} s  {:4.1f} %", name, seconds, 100.0 * seconds / all);
  log_traffic(s, log);
  if (std::abs(s.energy_drift) > notable_drift)
    log.warn(
        "warning: energy-drift: the scheme has made up or lost {:.1f} % of the energy, and what hangs on it is as "
        "wrong; "
        "a smaller scheme.courant, a finer spacing or another scheme may mend it",
        100.0 * s.energy_drift);
  if (s.angular_momentum_drift > notable_drift)
    log.warn(
        "warning: spin-drift: the angular momentum has changed by {:.1f} % of what is there if all turn one way: "
        "gradients that are not exact take what turns for shear; scheme.correction = \"mixed\", where the scheme "
        "knows it, or the scheme total-lagrangian may mend it",
        100.0 * *s.angular_momentum_drift);
}

}  // namespace tektite
