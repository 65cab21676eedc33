#include "postprocess/references.hpp"

#include <algorithm>
#include <cmath>

namespace tektite {
namespace {

/// What may be referred to: the measures of the scene, every kind, and the drifts that the solver reports.
std::map<std::string, Dimension> known_measures(const std::vector<NamedMeasure>& measures) {
  std::map<std::string, Dimension> known{{"energy_drift", dimension::none}, {"momentum_drift", dimension::none}};
  for (const auto& kind : measure_kinds()) known[kind.name] = kind.dimension;
  for (const auto& measure : measures) known[measure.name] = measure.kind->dimension;
  return known;
}

bool holds_for(Section& section, const std::string& variant) {
  auto variants = section.texts("variants", {});
  const auto single = section.text("variant", "");
  if (!single.empty()) variants.push_back(single);
  return variants.empty() || std::find(variants.begin(), variants.end(), variant) != variants.end();
}

Reference read_reference(Section& section, const std::map<std::string, Dimension>& known) {
  std::vector<std::string> names;
  for (const auto& [name, unit] : known) names.push_back(name);
  Reference reference;
  reference.measure = section.choice("measure", names);
  const auto unit = known.at(reference.measure);
  reference.unit = si_unit(unit);
  reference.published = section.quantity("published", unit);
  reference.source = section.text("source");
  if (section.has("within") && section.has("within_relative"))
    throw section.fault("within_relative", "within is given too", "one of the two");
  if (section.has("within")) reference.within = section.quantity("within", unit, limits::not_negative);
  if (section.has("within_relative"))
    reference.within =
        section.quantity("within_relative", dimension::none, limits::not_negative) * std::abs(reference.published);
  return reference;
}

}  // namespace

std::vector<Reference> read_references(const std::string& path, const std::string& variant,
                                       const std::vector<NamedMeasure>& measures) {
  auto document = Document::load(path, "", {});
  auto root = document.root();
  const auto known = known_measures(measures);
  std::vector<Reference> references;
  for (auto& section : root.list("reference")) {
    const bool holds = holds_for(section, variant);
    const auto reference = read_reference(section, known);
    section.finish();
    if (holds) references.push_back(reference);
  }
  root.finish();
  return references;
}

}  // namespace tektite
