#pragma once
// What a scene says about a run beside its physics: how long, what to write, where to look.

#include <string>
#include <vector>

#include "core/fields.hpp"
#include "core/scene.hpp"
#include "run/stop_conditions.hpp"
#include "schemes/scheme.hpp"

namespace tektite {

/// What a probe shows of its body: a particle, or the least or largest value that the body has at each time.
enum class Shown { particle, least, largest };

struct Probe {
  std::string name;
  std::string body;
  Shown shown = Shown::particle;
  std::vector<double> position;  ///< m, in the initial state; the nearest particles of the body are followed
  std::vector<Field> fields;     ///< an extreme shows each component's own
};

struct RunSettings {
  Scene scene;
  SchemeSettings scheme;
  std::map<std::string, Material> materials;
  double end = 0.0;                   ///< s
  bool from_contact = false;          ///< whether `end` counts from the first contact of two bodies
  double snapshot_interval = 0.0;     ///< s
  std::int64_t history_interval = 1;  ///< steps
  std::vector<Probe> probes;
  std::vector<StopCondition> stops;
};

/// Reads what the solver owns of a scene; afterwards `document` holds the effective values. Throws InputError.
RunSettings read_run_settings(Document& document);

/// Whether the bodies of a particle file and the materials of its scene fit together; throws InputError.
void check_bodies(const RunSettings& settings, const Particles& particles, const std::string& file);

/// Whether no particle starts behind the anvil by more than half a spacing; throws InputError.
void check_anvil(Document& document, const RunSettings& settings, const Particles& particles);

/// Whether every probe lies in its body at the start: within a spacing of a particle. Throws InputError.
void check_probes(Document& document, const RunSettings& settings, const Particles& particles);

/// Whether the run has what its probes show: `particles` as its scheme has allocated them. Throws InputError.
void check_probed_fields(Document& document, const RunSettings& settings, const Particles& particles);

}  // namespace tektite
