#include "run/energy_debt.hpp"

#include <algorithm>

namespace tektite {

double energy_debt(const Particles& particles, const Body& body) {
  constexpr double round_off = 1e-9;
  const auto mass = particles.reals(Field::mass), energy = particles.reals(Field::specific_internal_energy),
             velocity = particles.reals(Field::velocity);
  const auto dimensions = static_cast<std::size_t>(particles.dimensions());
  double whole = 0.0, internal = 0.0, kinetic = 0.0;
  double momentum[3] = {};
  for (std::size_t i = body.range.begin; i < body.range.end; ++i) {
    whole += mass[i];
    internal += mass[i] * energy[i];
    for (std::size_t k = 0; k < dimensions; ++k) {
      const double v = velocity[i * dimensions + k];
      momentum[k] += mass[i] * v;
      kinetic += 0.5 * mass[i] * v * v;
    }
  }
  if (internal >= -round_off * kinetic) return 0.0;
  double own = kinetic;
  for (const double component : momentum) own -= 0.5 * component * component / whole;
  return -internal / std::max(own, round_off * kinetic);
}

}  // namespace tektite
