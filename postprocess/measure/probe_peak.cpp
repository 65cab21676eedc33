// Largest pressure and largest tension that a probe saw.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "postprocess/measure/measure.hpp"

namespace tektite {
namespace {

std::string read_probe(Section& section, const Declared& declared) {
  std::vector<std::string> known;
  for (const auto& [name, body] : declared.body_of_probe) known.push_back(name);
  if (known.empty()) throw section.fault("probe", "the scene has no probe", "[probe.NAME]");
  return section.choice("probe", known);
}

/// The time that sound needs across half a spacing of the probe's body: within it the probe cannot tell its own place.
double blurred_time(const Event& event, const std::string& body_name) {
  const auto& body = event.last.bodies[static_cast<std::size_t>(event.last.body_named(body_name))];
  const auto& particles = event.last_snapshot.particles;
  if (!particles.has(Field::sound_speed)) return 0.0;
  const auto speed = particles.reals(Field::sound_speed).subspan(body.range.begin, body.range.size());
  double sum = 0.0;
  for (const double c : speed) sum += c;
  return sum > 0.0 ? 0.5 * body.spacing * static_cast<double>(body.range.size()) / sum : 0.0;
}

/// The largest of sign * pressure from the time `from` on, which counts from the first contact. Its uncertainty is half
/// of what the probe's value changes between the peak and the samples around it, as far as the nearest sample on either
/// side and the time that blurs the probe's place reach.
Measured peak(const Event& event, const std::string& probe, const std::string& body, double from, double sign) {
  if (!event.history) throw RunError("there is no history.csv, which holds the probes");
  const auto& time = event.history->column("time");
  const auto& pressure = event.history->column(probe + ".pressure");
  if (pressure.empty()) throw RunError(fmt::format("{} has no rows", event.history->path()));
  const double start = from + event.contact_time.value_or(0.0);
  const auto first = static_cast<std::size_t>(std::ranges::lower_bound(time, start) - time.begin());
  if (first == time.size())
    throw RunError(fmt::format("the run ends before the {} s from which it is looked for", start));
  std::size_t at = first;
  for (std::size_t k = first; k < pressure.size(); ++k)
    if (sign * pressure[k] > sign * pressure[at]) at = k;
  const double blur = blurred_time(event, body);
  double least = sign * pressure[at];
  for (std::size_t k = 0; k < pressure.size(); ++k) {
    const bool next_to_it = k + 1 == at || k == at + 1;
    if (next_to_it || std::abs(time[k] - time[at]) <= blur) least = std::min(least, sign * pressure[k]);
  }
  return {sign * pressure[at], time[at], 0.5 * (sign * pressure[at] - least), {}};
}

Measure read_peak(Section& section, const Declared& declared, double sign) {
  const auto probe = read_probe(section, declared);
  const auto body = declared.body_of_probe.at(probe);
  const double from = section.has("from") ? section.quantity("from", dimension::time, limits::not_negative)
                                          : -std::numeric_limits<double>::infinity();
  return {[=](const Event& event) { return peak(event, probe, body, from, sign); }, {Field::sound_speed}};
}

}  // namespace

Measure read_peak_pressure(Section& section, const Declared& declared) { return read_peak(section, declared, 1.0); }

/// Tension is negative pressure and given as a positive number; 0 or less where the probe never saw any.
Measure read_peak_tension(Section& section, const Declared& declared) { return read_peak(section, declared, -1.0); }

}  // namespace tektite
