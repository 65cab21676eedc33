#include "advice/plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "advice/impact.hpp"

namespace tektite {
namespace {

constexpr double osmium = 22590.0;   ///< kg/m³, the densest element
constexpr double diamond = 18600.0;  ///< m/s, the longitudinal wave along <111>
constexpr double most_crossings = 1e5;

/// The largest extent of all particles along an axis, m.
double largest_extent(const Particles& particles) {
  const auto width = static_cast<std::size_t>(particles.dimensions());
  const auto x = particles.reals(Field::position);
  double largest = 0.0;
  for (std::size_t k = 0; k < width; ++k) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t n = k; n < x.size(); n += width) {
      low = std::min(low, x[n]);
      high = std::max(high, x[n]);
    }
    largest = std::max(largest, high - low);
  }
  return largest;
}

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

std::vector<std::string> implausible_end(const Particles& particles, const RunSettings& settings) {
  double slowest = std::numeric_limits<double>::infinity();
  for (const auto& body : particles.bodies())
    slowest = std::min(slowest, wave_speed_at_rest(settings.materials.at(body.material)));
  const double crossing = largest_extent(particles) / slowest;
  if (settings.end <= most_crossings * crossing) return {};
  return {
      fmt::format("the end comes after {:.1e} times what waves take through everything, {:.2g} s: is the unit of "
                  "time.end = {:g} s right?",
                  settings.end / crossing, crossing, settings.end)};
}

}  // namespace tektite
