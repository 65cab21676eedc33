#include "advice/plausibility.hpp"

#include <fmt/format.h>

#include "advice/impact.hpp"

namespace tektite {
namespace {

constexpr double osmium = 22590.0;   ///< kg/m³, the densest element
constexpr double diamond = 18600.0;  ///< m/s, the longitudinal wave along <111>

}  // namespace

std::vector<std::string> implausible(const std::map<std::string, Material>& materials) {
  std::vector<std::string> lines;
  for (const auto& [name, material] : materials) {
    if (material.density > osmium)
      lines.push_back(fmt::format("material {}: {:g} kg/m3 is more than osmium has, {:g}: is the unit right?", name,
                                  material.density, osmium));
    if (const double speed = wave_speed_at_rest(material); speed > diamond)
      lines.push_back(
          fmt::format("material {}: waves of {:.4g} m/s are faster than in diamond, {:g}: are the units of density "
                      "({:g} kg/m3) and moduli right?",
                      name, speed, diamond, material.density));
  }
  return lines;
}

}  // namespace tektite
