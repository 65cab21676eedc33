#include <fmt/format.h>

#include "core/error.hpp"
#include "core/plain_name.hpp"
#include "postprocess/measure/measure.hpp"

namespace tektite {

#define MEASURE(name, kind_dimension) Measure read_##name(Section& section, const Declared& declared);
#include "postprocess/measure/kinds.def"
#undef MEASURE

std::span<const MeasureKind> measure_kinds() {
  static const std::vector<MeasureKind> kinds{
#define MEASURE(name, kind_dimension) {#name, dimension::kind_dimension, read_##name},
#include "postprocess/measure/kinds.def"
#undef MEASURE
  };
  return kinds;
}

std::vector<NamedMeasure> read_measures(Section& root, const Declared& declared) {
  std::vector<std::string> known;
  for (const auto& kind : measure_kinds()) known.push_back(kind.name);
  std::vector<NamedMeasure> measures;
  for (auto& [name, section] : root.named_sections("measure")) {
    if (!is_plain_name(name))
      throw section.fault("", "names a number of measurements.json, so it must be plain", plain_characters);
    const auto type = section.choice("type", known, name);
    for (const auto& kind : measure_kinds())
      if (kind.name == type) measures.push_back({name, &kind, kind.read(section, declared)});
    section.finish();
  }
  return measures;
}

void require_field(const Particles& particles, Field field) {
  if (!particles.has(field)) throw RunError(fmt::format("the snapshot has no {}", info(field).name));
}

std::string read_body(Section& section, const std::string& key, const Declared& declared) {
  return section.choice(key, declared.bodies);
}

}  // namespace tektite
