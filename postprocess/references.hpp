#pragma once
// Published values beside ours.
//
//   [[reference]]
//   measure = "crater_diameter"     # a measure of the scene, or energy_drift, momentum_drift
//   variant = "sav1"                # or variants = ["sav1", "con"]; for every variant where neither is given
//   published = "2.1 cm"
//   within = "0.1 cm"               # or within_relative = 0.03; neither: the difference is told without a verdict
//   source = "..."

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "postprocess/measure/measure.hpp"

namespace tektite {

struct Reference {
  std::string measure;
  std::string source;
  std::string unit;
  double published = 0.0;        ///< in SI
  std::optional<double> within;  ///< in SI
};

/// Reads the entries that hold for `variant`. Throws InputError.
std::vector<Reference> read_references(const std::string& path, const std::string& variant,
                                       const std::vector<NamedMeasure>& measures);

}  // namespace tektite
