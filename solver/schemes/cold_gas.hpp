#pragma once

#include <algorithm>
#include <string>

#include "schemes/scheme.hpp"

namespace tektite {

/// Refuses an ideal gas without energy where contacts act by the speed of sound, of which it has none: it would go
/// through itself without a word. Throws InputError.
inline void refuse_cold_gas(const SchemeSetup& setup) {
  const auto& particles = setup.particles;
  for (const auto& body : particles.bodies()) {
    const auto& material = setup.materials.at(body.material);
    if (!std::holds_alternative<IdealGas>(material.eos)) continue;
    const auto has_energy = [&] {
      const auto energy = particles.reals(Field::specific_internal_energy);
      return std::ranges::all_of(energy.subspan(body.range.begin, body.range.size()), [](double e) { return e > 0.0; });
    };
    if (particles.has(Field::specific_internal_energy) && has_energy()) continue;
    throw InputError({{},
                      "material." + material.name + ".eos",
                      std::string(IdealGas::name),
                      "without energy it has no sound speed, by which the contacts of " + setup.settings.type + " act",
                      "godunov-split of order 1 with riemann exact, or another scheme"});
  }
}

}  // namespace tektite
