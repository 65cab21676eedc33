#include "advice/viscosity.hpp"

#include <fmt/format.h>

#include <cmath>

#include "advice/flow_stress.hpp"
#include "advice/thickness.hpp"
#include "parallel/body_mean.hpp"

namespace tektite {

std::vector<std::string> viscous_strengths(const Particles& particles, const RunSettings& settings,
                                           const std::vector<Meeting>& meetings) {
  const auto* viscosity = std::get_if<MonaghanViscosity>(&settings.scheme.viscosity);
  const int dimensions = particles.dimensions();
  std::vector<std::string> lines;
  if (!viscosity || viscosity->alpha == 0.0 || dimensions == 1) return lines;
  const auto thickness = [&](const Body& body) {
    return body.spacing * particles_through(particles, body, settings.scene.symmetry);
  };
  const auto look_at = [&](const Body& body, double rate, const char* thinner) {
    const auto& material = settings.materials.at(body.material);
    const auto flow = flow_stress(material, rate);
    if (!flow) return;
    const double h = particles.reals(Field::smoothing_length)[body.range.begin];
    const double sound = std::sqrt(bulk_modulus_of(material) / material.density);
    const double viscous =
        3.0 * viscosity->alpha * material.density * sound * h / (dimensions == 2 ? 8.0 : 10.0) * rate;
    if (viscous <= *flow) return;
    lines.push_back(
        fmt::format("{}: where it flows at the closing speed over the {}, {:.1e} /s, the artificial viscosity "
                    "bears some {:.2g} GPa, more than the flow stress of {:.2g} GPa, and slows the flow as a "
                    "strength would; a finer spacing, a smaller viscosity.alpha ({:.1g} makes both equal) or "
                    "viscosity.model = 'limited' lowers it",
                    body.name, thinner, rate, 1e-9 * viscous, 1e-9 * *flow, viscosity->alpha * *flow / viscous));
  };
  for (const auto& meeting : meetings) {
    const double rate = meeting.closing_speed / std::min(thickness(*meeting.first), thickness(*meeting.second));
    for (const Body* body : {meeting.first, meeting.second}) look_at(*body, rate, "thinner body");
  }
  if (const auto& anvil = settings.scheme.anvil)
    for (const auto& body : particles.bodies()) {
      const auto velocity = mean_over(particles, body, Field::velocity);
      const double speed = -anvil->side * velocity[static_cast<std::size_t>(anvil->axis)];
      if (speed > 0.0) look_at(body, speed / thickness(body), "body's thickness");
    }
  return lines;
}

}  // namespace tektite
