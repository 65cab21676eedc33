#include "advice/weak_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>
#include <variant>

#include "advice/contact_strength.hpp"
#include "physics/kernels/kernel.hpp"

namespace tektite {
namespace {

Face face_of(const Particles& particles, const Body& body, const RunSettings& settings) {
  return {bulk_modulus_of(settings.materials.at(body.material)),
          particles.reals(Field::smoothing_length)[body.range.begin], body.spacing};
}

/// Pa, by the kernel that the scene names.
double largest_pressure(const Face& a, const Face& b, const RunSettings& settings, int dimensions) {
  const auto& contact = *settings.scheme.contact;
  double pressure = 0.0;
  [&]<class... Kernels>(std::type_identity<std::variant<Kernels...>>) {
    const auto take = [&]<class K>(std::type_identity<K>) {
      if (K::name != settings.scheme.kernel) return;
      pressure = dimensions == 1   ? largest_contact_pressure<K, 1>(a, b, contact.factor, contact.exponent)
                 : dimensions == 2 ? largest_contact_pressure<K, 2>(a, b, contact.factor, contact.exponent)
                                   : largest_contact_pressure<K, 3>(a, b, contact.factor, contact.exponent);
    };
    (take(std::type_identity<Kernels>{}), ...);
  }(std::type_identity<Kernel>{});
  return pressure;
}

}  // namespace

std::vector<std::string> weak_contacts(const Particles& particles, const RunSettings& settings,
                                       const std::vector<Meeting>& meetings) {
  constexpr double margin = 2.0;  // what is advised bears so much more than the impact asks for
  std::vector<std::string> lines;
  if (!settings.scheme.contact) return lines;
  for (const auto& meeting : meetings) {
    const auto a = face_of(particles, *meeting.first, settings), b = face_of(particles, *meeting.second, settings);
    if (std::min(a.bulk_modulus, b.bulk_modulus) <= 0.0) {
      lines.push_back(
          fmt::format("{} and {}: a contact is as stiff as the softer body at rest, and a gas is not at "
                      "all: they run through each other",
                      meeting.first->name, meeting.second->name));
      continue;
    }
    if (!meeting.shocked) continue;
    const double asked = meeting.shocked->first.pressure;
    const double held = largest_pressure(a, b, settings, particles.dimensions());
    if (asked <= held) continue;
    lines.push_back(
        fmt::format("{} and {}: their contact bears at most {:.3g} GPa with contact.factor = {:g}, and the "
                    "impact has {:.3g} GPa: they run into each other; a factor of {:.2g} holds them",
                    meeting.first->name, meeting.second->name, 1e-9 * held, settings.scheme.contact->factor,
                    1e-9 * asked, margin * settings.scheme.contact->factor * asked / held));
  }
  return lines;
}

}  // namespace tektite
