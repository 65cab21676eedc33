#include "run/energy_debt.hpp"

#include <algorithm>

#include "parallel/sums.hpp"

namespace tektite {

double energy_debt(const Particles& particles, const Body& body) {
  constexpr double round_off = 1e-9;
  const auto mass = particles.reals(Field::mass), energy = particles.reals(Field::specific_internal_energy),
             velocity = particles.reals(Field::velocity);
  const auto dimensions = static_cast<std::size_t>(particles.dimensions());
  const auto sums = sum_over<6>(particles, body.range, [=](std::size_t i) {
    std::array<double, 6> terms{mass[i], mass[i] * energy[i]};
    for (std::size_t k = 0; k < dimensions; ++k) {
      const double v = velocity[i * dimensions + k];
      terms[2] += 0.5 * mass[i] * v * v;
      terms[3 + k] = mass[i] * v;
    }
    return terms;
  });
  const auto [whole, internal, kinetic, px, py, pz] = sums;
  if (internal >= -round_off * kinetic) return 0.0;
  double own = kinetic;
  for (const double component : {px, py, pz}) own -= 0.5 * component * component / whole;
  return -internal / std::max(own, round_off * kinetic);
}

}  // namespace tektite
