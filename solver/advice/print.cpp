#include "advice/print.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/counted.hpp"
#include "output/progress.hpp"
#include "parallel/threads.hpp"

namespace tektite {
namespace {

std::string shown_bytes(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.3g} MB", 1e-6 * bytes) : fmt::format("{:.3g} GB", 1e-9 * bytes);
}

std::string shown_duration(double seconds) {
  return seconds < 100.0 ? fmt::format("{:.3g} s", seconds) : shown_clock(seconds);
}

/// What is said of the disk beside the bytes that a run wants, where it has less room for the user than that.
std::string shown_lack(double bytes) {
  std::error_code unknown;
  const auto room = std::filesystem::space(".", unknown);
  if (unknown || bytes <= static_cast<double>(room.available)) return {};
  return fmt::format(", more than the {} that are free here", shown_bytes(static_cast<double>(room.available)));
}

}  // namespace

void print_scene(const Simulation& simulation) {
  const auto& settings = simulation.settings();
  fmt::print("scheme {} in {}, kernel {}, h/δ = {:g}\n", settings.scheme.type, name_of(settings.scene.space),
             settings.scheme.kernel, settings.scene.smoothing_ratio);
  for (const auto& [name, material] : settings.materials) {
    const auto eos = std::visit([](const auto& model) { return model.name; }, material.eos);
    const auto strength = std::visit([](const auto& model) { return model.name; }, material.strength);
    fmt::print("material {}: density {:g} kg/m3, equation of state {}, strength {}\n", name, material.density, eos,
               strength);
  }
  for (const auto& plane : settings.scene.symmetry)
    fmt::print("symmetry plane {} = {:g} m\n", "xyz"[plane.axis], plane.at);
}

void print(const Forecast& forecast, const Simulation& simulation) {
  const auto& settings = simulation.settings();
  fmt::print("until {}{}: about {:.0f} step{}, the first of {}\n", shown_time(settings.end),
             settings.from_contact ? " after contact" : "", forecast.steps, forecast.steps == 1.0 ? "" : "s",
             shown_time(forecast.first_dt));
  for (const auto& stop : settings.stops) fmt::print("stops earlier where {}\n", in_words(stop));
  fmt::print("about {} on {}; memory {}, {:.0f} bytes a particle; disk {}, {} a snapshot{}\n",
             shown_duration(forecast.seconds), counted(static_cast<std::size_t>(threads_in_use()), "thread"),
             shown_bytes(forecast.memory_bytes), forecast.bytes_per_particle, shown_bytes(forecast.disk_bytes),
             shown_bytes(forecast.snapshot_bytes), shown_lack(forecast.disk_bytes));
}

void print(const Advice& advice) {
  for (const auto& line : advice.lines) fmt::print("advice: {}\n", line);
}

}  // namespace tektite
