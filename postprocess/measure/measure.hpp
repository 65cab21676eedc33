#pragma once
// What a measure is: read from [measure.NAME] once, then taken of an event. The kinds stand in kinds.def; a new one is
// one new file with its reader and one line there.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/document.hpp"
#include "postprocess/history.hpp"
#include "postprocess/measure/connectivity.hpp"
#include "postprocess/whole.hpp"

namespace tektite {

/// What the scene declares and a measure may name.
struct Declared {
  Space space = Space::line;
  std::vector<std::string> bodies;
  std::map<std::string, std::string> body_of_probe;
};

/// What happened, as far as measures look at it. All particles are whole (mirrored).
struct Event {
  Whole initial;
  Whole last;
  Snapshot last_snapshot;      ///< with the fields at least that the measures declare
  Fragments fragments;         ///< of `last`, linked over the support of the kernel
  Fragments narrow_fragments;  ///< of `last`, linked over one smoothing length
  std::optional<History> history;
  std::optional<double> contact_time;  ///< in s
  std::vector<std::string> snapshots;  ///< files by time, the initial state first
  std::vector<double> times;           ///< of the snapshots, s
  std::vector<SymmetryPlane> symmetry;
};

/// Which of the snapshots is nearest to a time.
inline std::size_t nearest_snapshot(const Event& event, double time) {
  const auto away = [time](double at) { return std::abs(at - time); };
  return static_cast<std::size_t>(std::ranges::min_element(event.times, {}, away) - event.times.begin());
}

/// A line to draw for a measure, in the coordinates of the scene.
struct Segment {
  Point from;
  Point to;
};

struct Measured {
  double value = 0.0;        ///< in SI
  double time = 0.0;         ///< in s: when it is so
  double uncertainty = 0.0;  ///< in the unit of the value
  std::optional<Segment> drawing;
};

/// Throws RunError where the event does not hold what the measure needs.
struct Measure {
  template <std::invocable<const Event&> Take>
  Measure(Take how, FieldSet of = {}) : take(std::move(how)), fields(std::move(of)) {}  // NOLINT: a measure is that
  Measured operator()(const Event& event) const { return take(event); }

  std::function<Measured(const Event&)> take;
  FieldSet fields;  ///< those of the last snapshot that it looks at, beside what Whole has: no others are read
};

struct MeasureKind {
  std::string name;
  Dimension dimension;
  Measure (*read)(Section& section, const Declared& declared);
};

/// All kinds, in the order of kinds.def.
std::span<const MeasureKind> measure_kinds();

/// One measure of a scene: [measure.NAME], whose kind is NAME unless `type` says otherwise.
struct NamedMeasure {
  std::string name;
  const MeasureKind* kind = nullptr;
  Measure measure;
};

/// Reads the tables [measure.NAME]; an unknown kind, body or probe is answered with the known ones.
std::vector<NamedMeasure> read_measures(Section& root, const Declared& declared);

/// Throws RunError where a snapshot does not have what a measure is taken of: the initial state has neither pressure
/// nor stress, and no run has the damage of material that cannot fail.
void require_field(const Particles& particles, Field field);

/// The key `body` of a measure (or another key that names one).
std::string read_body(Section& section, const std::string& key, const Declared& declared);

}  // namespace tektite
