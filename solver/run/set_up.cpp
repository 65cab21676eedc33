#include "run/set_up.hpp"

#include <utility>

#include "output/history.hpp"
#include "output/probes.hpp"

namespace tektite {

Document scene_of(const Snapshot& snapshot, const std::string& file) {
  return Document::parse(snapshot.scene, file + ":/scene");
}

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

Simulation simulation_of(Snapshot snapshot, RunSettings settings, bool resumed, Document& document) {
  try {
    return {std::move(snapshot), std::move(settings), resumed};
  } catch (const InputError& fault) {
    throw document.placed(fault);
  }
}

}  // namespace tektite
