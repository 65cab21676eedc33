#include "postprocess/shown_unit.hpp"

#include <array>
#include <cmath>

namespace tektite {
namespace {

struct Choice {
  const char* si_unit;
  double size;  ///< of the shown unit in SI
  const char* label;
};

// For each SI unit from large to small; the last one is taken for everything that is smaller.
constexpr std::array<Choice, 25> choices{{
    {"m", 1.0, "m"},       {"m", 1e-3, "mm"},    {"m", 1e-6, "µm"},   {"s", 1.0, "s"},        {"s", 1e-3, "ms"},
    {"s", 1e-6, "µs"},     {"s", 1e-9, "ns"},    {"Pa", 1e9, "GPa"},  {"Pa", 1e6, "MPa"},     {"Pa", 1e3, "kPa"},
    {"Pa", 1.0, "Pa"},     {"m/s", 1e3, "km/s"}, {"m/s", 1.0, "m/s"}, {"J", 1e9, "GJ"},       {"J", 1e6, "MJ"},
    {"J", 1e3, "kJ"},      {"J", 1.0, "J"},      {"J", 1e-3, "mJ"},   {"J/kg", 1e6, "MJ/kg"}, {"J/kg", 1e3, "kJ/kg"},
    {"J/kg", 1.0, "J/kg"}, {"kg", 1.0, "kg"},    {"kg", 1e-3, "g"},   {"kg", 1e-6, "mg"},     {"kg/m3", 1.0, "kg/m³"},
}};

}  // namespace

ShownUnit shown_unit(double magnitude, const std::string& si_unit) {
  // Slightly below the limit counts as reaching it: 1 mm that is 0.999999999 mm after arithmetic is still 1 mm.
  const double reach = std::abs(magnitude) * (1.0 + 1e-9);
  ShownUnit shown{1.0, si_unit == "1" ? "" : si_unit};
  for (const auto& choice : choices) {
    if (si_unit != choice.si_unit) continue;
    shown = {1.0 / choice.size, choice.label};
    if (reach >= choice.size) break;
  }
  if (magnitude == 0.0) return {1.0, si_unit == "1" ? "" : si_unit};
  return shown;
}

}  // namespace tektite
