#include "run/watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "run/energy_debt.hpp"
#include "run/hourglass_share.hpp"
#include "run/locking.hpp"
#include "run/misfit.hpp"
#include "run/too_near.hpp"
#include "run/wall_heating.hpp"
#include "schemes/godunov_settings.hpp"

namespace tektite {
namespace {

bool is_gas(const Material& material) { return std::holds_alternative<IdealGas>(material.eos); }

/// Whether no drift of the energy tells of motion that the scheme has made up. Of the others it does, and bodies that
/// start stretched or pressed without the energy of that are common for them.
bool keeps_total(const SchemeSettings& scheme) { return scheme.type.starts_with("godunov"); }

std::string_view remedy_for_debt(const SchemeSettings& scheme) {
  if (scheme.type != "godunov-split") return "another scheme";
  if (scheme.godunov->strang) return "scheme.splitting = 'lie-trotter', or a smaller scheme.courant,";
  return "scheme.order = 1, which damps waves, or the limiter sweby with beta = 1, which steepens them the least,";
}

/// Beside total-Lagrangian kernels, as far as the scheme knows it.
std::string_view other_remedy_for_clumps(const SchemeSettings& scheme, int dimensions) {
  const bool knows = dimensions == 2 && (scheme.type == "eulerian" || scheme.type == "adaptle");
  if (!knows) return "";
  return scheme.artificial_stress ? " or a larger scheme.artificial_stress.epsilon" : " or scheme.artificial_stress";
}

/// What keeps bodies apart that run into each other, as far as the scheme knows it.
std::string remedy_for_interpenetration(const SchemeSettings& scheme) {
  if (scheme.type == "msph" || scheme.type == "ssph") return "a finer spacing or another scheme";
  const bool lagrangian = scheme.type == "total-lagrangian" || scheme.type == "adaptle";
  std::string remedy = !scheme.contact ? "[contact]" : "a larger contact.factor";
  if (lagrangian && !(scheme.contact && scheme.contact->itself)) remedy += ", contact.itself for pieces of one body";
  if (lagrangian || scheme.type == "eulerian") remedy += ", a larger viscosity.beta";
  return remedy + " or a finer spacing";
}

/// Under which a snapshot keeps what has been told, as `warning.NAME` or `warning.NAME.BODY`.
constexpr std::string_view prefix = "warning.";

/// Of as many bodies what is found of the same name has a line each; of more of them the first has one for all.
constexpr std::ptrdiff_t told_each = 4;

std::vector<Warning> together(const std::vector<Warning>& of_bodies) {
  std::vector<Warning> lines;
  for (const auto& warning : of_bodies) {
    const auto same = [&](const Warning& other) { return other.name == warning.name; };
    const auto bodies = std::ranges::count_if(of_bodies, same);
    if (bodies <= told_each)
      lines.push_back(warning);
    else if (std::ranges::none_of(lines, same))
      lines.push_back(
          {warning.name, fmt::format("of {} bodies, of which this is the first: {}", bodies, warning.text)});
  }
  return lines;
}

}  // namespace

Watch::Watch(const std::map<std::string, double>& state) {
  for (const auto& [key, value] : state)
    if (key.starts_with(prefix)) told_.insert(key.substr(prefix.size()));
}

void Watch::save(std::map<std::string, double>& state) const {
  for (const auto& told : told_) state[std::string(prefix) + told] = 1.0;
}

std::set<std::string> Watch::names() const {
  std::set<std::string> names;
  for (const auto& told : told_) names.insert(told.substr(0, told.find('.')));
  return names;
}

void Watch::tell(std::vector<Warning>& found, const std::string& name, const std::string& body, std::string text) {
  if (told_.insert(body.empty() ? name : name + '.' + body).second) found.push_back({name, std::move(text)});
}

void Watch::look_at(const Particles& particles, const Body& body, const RunSettings& settings,
                    std::vector<Warning>& found) {
  const auto& material = settings.materials.at(body.material);
  if (!is_gas(material))
    if (const double part = clumped_part(particles, body); part > too_near_share)
      tell(
          found, "clumping", body.name,
          fmt::format("{:.0f} % of the particles of {} lie nearer to another one than a third of their spacing, as the "
                      "tensile instability leaves them: cracks and fragments there are not the material's; "
                      "total-Lagrangian kernels{} may mend it",
                      100.0 * part, body.name, other_remedy_for_clumps(settings.scheme, particles.dimensions())));
  if (const double part = interpenetrated_part(particles, body); part > too_near_share)
    tell(found, "interpenetration", body.name,
         fmt::format("{:.0f} % of the particles of {} lie nearer than a third of their spacing to particles that were "
                     "not their neighbours: bodies have run into each other there, and the pressure between them is "
                     "too small; {} may mend it",
                     100.0 * part, body.name, remedy_for_interpenetration(settings.scheme)));
  if (const double part = beyond_planes_part(particles, body, settings.scene.symmetry); part > too_near_share)
    tell(found, "interpenetration", body.name,
         fmt::format("{:.0f} % of the particles of {} lie beyond a symmetry plane: kernels of the reference "
                     "configuration do not see the images of particles that were not near the plane at the start; "
                     "contact.itself, or the scheme eulerian, holds them",
                     100.0 * part, body.name));
  if (const double part = hourglass_share(particles, body, material); part > notable_hourglass)
    tell(found, "hourglass", body.name,
         fmt::format("neighbours in {} have moved against each other as kernels of the reference configuration do not "
                     "see it: as a strain it would hold {:.0f} % of all energy that the body has stored and "
                     "dissipated; scheme.hourglass_control against zero-energy modes, the scheme adaptle against slip "
                     "may mend it",
                     body.name, 100.0 * part));
  const auto fit = misfit(particles, body);
  if (fit.part > misfit_share)
    tell(found, "density-misfit", body.name,
         fmt::format("the densities of {:.0f} % of the particles of {} are not those of their places: the kernel finds "
                     "{:.2f} of them on average; a correction of the kernel or the scheme msph may mend a part of it",
                     100.0 * fit.part, body.name, fit.mean_sum));
  if (is_gas(material) && fit.untouched > untouched_share)
    tell(found, "lost-neighbours", body.name,
         fmt::format("{:.1f} % of the particles of {} have pressure and no neighbour: the gas has stopped to expand "
                     "there, too dense and too slow; a larger smoothing.ratio lets it go further",
                     100.0 * fit.untouched, body.name));
  if (is_gas(material))
    if (const double heat = heat_at_walls(particles, body, settings.scene.symmetry); heat > notable_heat)
      tell(found, "wall-heating", body.name,
           fmt::format("next to a symmetry plane or axis {} has {:.2f} times the specific energy that it has further "
                       "inside, where that is even: heat of a shock that was born there; a finer spacing only narrows "
                       "it, the scheme msph smooths it",
                       body.name, heat));
  if (const double debt = energy_debt(particles, body); keeps_total(settings.scheme) && debt > notable_debt)
    tell(
        found, "energy-debt", body.name,
        fmt::format("the internal energy of {} is below zero, by {:.2g} of its kinetic energy in its own frame: motion "
                    "has grown there that nothing drives, though the total is kept; {} may mend it",
                    body.name, debt, remedy_for_debt(settings.scheme)));
  if (const auto locks = locking(body.name, material)) tell(found, "locking", body.name, *locks);
}

std::vector<Warning> Watch::note(const std::vector<Warning>& warnings) {
  std::vector<Warning> found;
  for (const auto& warning : warnings) tell(found, warning.name, {}, warning.text);
  return found;
}

std::vector<Warning> Watch::look(const Particles& particles, const RunSettings& settings,
                                 const std::vector<Warning>& of_scheme) {
  auto found = note(of_scheme);
  std::vector<Warning> of_bodies;
  for (const auto& body : particles.bodies()) look_at(particles, body, settings, of_bodies);
  std::ranges::move(together(of_bodies), std::back_inserter(found));
  return found;
}

}  // namespace tektite
