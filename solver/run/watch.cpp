#include "run/watch.hpp"

#include <fmt/format.h>

#include "run/hourglass_share.hpp"
#include "run/too_near.hpp"

namespace tektite {

bool Watch::is_new(const std::string& name, const std::string& body) {
  names_.insert(name);
  return told_.insert(name + ' ' + body).second;
}

std::vector<Warning> Watch::look(const Particles& particles, const std::map<std::string, Material>& materials,
                                 const std::vector<Warning>& of_scheme) {
  std::vector<Warning> found;
  const auto tell = [&](const std::string& name, const std::string& body, const std::string& text) {
    if (is_new(name, body)) found.push_back({name, text});
  };
  for (const auto& warning : of_scheme) tell(warning.name, {}, warning.text);
  for (const auto& body : particles.bodies()) {
    if (const double part = clumped_part(particles, body, materials.at(body.material).density); part > too_near_share)
      tell(
          "clumping", body.name,
          fmt::format("{:.0f} % of the particles of {} lie nearer to another one than a third of their spacing, as the "
                      "tensile instability leaves them: cracks and fragments there are not the material's; "
                      "total-Lagrangian kernels or scheme.artificial_stress may mend it",
                      100.0 * part, body.name));
    if (const double part = interpenetrated_part(particles, body, materials); part > too_near_share)
      tell(
          "interpenetration", body.name,
          fmt::format("{:.0f} % of the particles of {} lie nearer than a third of their spacing to particles that were "
                      "not their neighbours: bodies have run into each other there, and the pressure between them is "
                      "too small; a larger contact.factor, contact.itself for pieces of one body, or a larger "
                      "viscosity.beta may mend it",
                      100.0 * part, body.name));
    if (const double part = hourglass_share(particles, body, materials.at(body.material)); part > notable_hourglass)
      tell(
          "hourglass", body.name,
          fmt::format("neighbours in {} have moved against each other as kernels of the reference configuration do not "
                      "see it: as a strain it would hold {:.0f} % of all energy that the body has stored and "
                      "dissipated; scheme.hourglass_control against zero-energy modes, the scheme adaptle against slip "
                      "may mend it",
                      body.name, 100.0 * part));
  }
  return found;
}

}  // namespace tektite
