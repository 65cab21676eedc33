#include "advice/forecast.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "output/history.hpp"
#include "output/probes.hpp"
#include "output/summary.hpp"
#include "parallel/threads.hpp"

namespace tektite {
namespace {

constexpr std::int64_t least_steps = 5;

/// What the files for ParaView keep of the fields' bytes when they are packed: 0.70 to 0.79 in runs of hvi_2d,
/// debris_3d, collapsing_ring and taylor_bar.
constexpr double packing = 0.75;
/// Of memory, bytes: the first snapshot takes so much beside the particles and their copy, 1.8 to 2.0 MB in five
/// examples.
constexpr double writing = 1.9e6;
/// Of a number in history.csv with its comma: 15 to 17 characters in the same runs.
constexpr double characters = 16.0;

double bytes_of_fields(const Particles& particles, bool shown_alone) {
  double bytes = 0.0;
  for (const auto& row : field_table)
    if (particles.has(row.field) && (row.keep == Keep::result || (row.keep == Keep::restart && !shown_alone)))
      bytes += static_cast<double>(bytes_of(row.field, particles.space()));
  return bytes * static_cast<double>(particles.count());
}

/// Linear coefficient of the viscosity.
double alpha_of(const RunSettings& settings) {
  return std::visit([](const auto& viscosity) { return viscosity.alpha; }, settings.scheme.viscosity);
}

/// The time from the start to the end of the run, s.
double duration(const Simulation& simulation, const std::vector<Meeting>& meetings) {
  if (const double end = simulation.end(); std::isfinite(end)) return end;
  double flight = std::numeric_limits<double>::infinity();
  for (const auto& meeting : meetings) flight = std::min(flight, meeting.arrival);
  return simulation.settings().end + (std::isfinite(flight) ? flight : 0.0);
}

}  // namespace

Forecast forecast_of(Simulation& simulation, const std::vector<Meeting>& meetings, double calibration_seconds) {
  const auto& settings = simulation.settings();
  const auto& particles = simulation.particles();
  Forecast forecast;
  simulation.step();  // finds the neighbours for the first time
  forecast.first_dt = simulation.last_step().dt;
  const RunTimer timer;
  while (!simulation.finished() &&
         (simulation.steps_taken() < least_steps || timer.cpu_seconds() < calibration_seconds))
    simulation.step();
  const auto timed = static_cast<double>(std::max<std::int64_t>(1, simulation.steps_taken() - 1));
  const double seconds = timer.cpu_seconds() / timed / threads_in_use();

  const double dt = meetings.empty()
                        ? simulation.last_step().dt
                        : forecast.first_dt / step_shortening(meetings, settings.materials, alpha_of(settings));
  const double left = std::max(0.0, duration(simulation, meetings) - simulation.time());
  forecast.steps = static_cast<double>(simulation.steps()) + std::ceil(left / dt);
  forecast.seconds = forecast.steps * seconds;

  forecast.bytes_per_particle =
      static_cast<double>(particles.memory() + simulation.scheme().memory()) / static_cast<double>(particles.count());
  forecast.snapshot_bytes = bytes_of_fields(particles, false);
  forecast.memory_bytes = static_cast<double>(peak_memory()) + writing + forecast.snapshot_bytes;  // and its copy
  const double snapshots = 1.0 + std::ceil(settings.end / settings.snapshot_interval);
  const double shown = packing * bytes_of_fields(particles, true);
  const auto columns =
      5 + number_columns(particles.space(), Probes(settings.probes, particles).columns(particles)).size();
  const double lines = forecast.steps / static_cast<double>(settings.history_interval);
  forecast.disk_bytes =
      snapshots * (forecast.snapshot_bytes + shown) + characters * lines * static_cast<double>(columns);
  return forecast;
}

}  // namespace tektite
