#include "run/check.hpp"

#include <fmt/format.h>

#include "advice/print.hpp"
#include "core/write_beside.hpp"
#include "output/probes.hpp"
#include "parallel/threads.hpp"
#include "run/set_up.hpp"

namespace tektite {
namespace {

/// Processor time that is spent on steps to measure what they cost.
constexpr double calibration_seconds = 0.5;

/// What a run says in several lines, as an input error has one.
std::string on_one_line(const std::string& text) {
  std::string line;
  for (const char c : text)
    if (c == '\n')
      line += ';';
    else if (c != ' ' || !line.ends_with(' '))
      line += c;
  return line;
}

}  // namespace

void check(const CheckOptions& options) {
  auto snapshot = read_snapshot(options.particles);
  use_threads(options.threads, snapshot.particles.count());
  auto document = scene_of(snapshot, options.particles);
  auto settings = settings_of(snapshot, options.particles, document);
  const auto met = meetings(snapshot.particles, settings.materials);
  Advice advice;
  if (options.advice) advice = advise(snapshot.particles, settings, met, document);
  auto simulation = simulation_of(std::move(snapshot), std::move(settings), false, document);
  const auto& particles = simulation.particles();
  check_probed_fields(document, simulation.settings(), particles);
  std::optional<InputError> failure;
  try {
    print_scene(simulation);
    for (const auto& line : Probes(simulation.settings().probes, particles).in_words(particles))
      fmt::print("{}\n", line);
    print(forecast_of(simulation, met, options.advice ? calibration_seconds : 0.0), simulation);
  } catch (const RunError& fault) {
    failure = document.placed(InputError(fmt::format("the first steps fail: {}", on_one_line(fault.what()))));
  }
  if (failure) throw *failure;
  if (!options.advice) return;
  print(advice);
  write_text_beside(*options.advice, fmt::format("{}\n", fmt::join(advice.settings, "\n")));
}

}  // namespace tektite
