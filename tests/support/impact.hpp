#pragma once
// An oblique impact of two small bodies in every space, with everything in it that a step has: contact, compression,
// plastic flow, new neighbour lists every few steps.

#include <string>

#include "support/lattice.hpp"

namespace tektite::test {

inline constexpr double impact_spacing = 1e-3;  // m

/// Both bodies stand in cells of one lattice, a spacing apart; nothing is symmetric about them.
inline Particles impact_particles(Space space) {
  const double d = impact_spacing;
  const std::size_t dimensions = static_cast<std::size_t>(dimensions_of(space));
  Lattice projectile{"projectile", "metal", d, {-20.5 * d, -4.5 * d, -3.5 * d}, {20, 16, 6}, {1500.0, 400.0, 200.0}};
  Lattice target{"target", "plate", d, {0.5 * d, -15.5 * d, -6.5 * d}, {6, 40, 14}, {0.0, 0.0, 0.0}};
  if (space == Space::solid) {
    projectile.first[0] = -6.5 * d;
    projectile.count = {6, 7, 5};
    target.first[1] = -5.5 * d;
    target.count = {3, 13, 12};
  }
  for (auto* lattice : {&projectile, &target}) {
    lattice->first.resize(dimensions);
    lattice->count.resize(dimensions);
    lattice->velocity.resize(dimensions);
  }
  return particles_on(space, {projectile, target}, 2785.0);
}

/// Two materials with different models, so that nothing is shared by chance.
inline const std::string impact_scene =
    "time.end = '1 ms'\n"
    "[material.metal]\ndensity = 2785.0\n"
    "eos = { model = 'stiffened-gas', bulk_sound_speed = 5328.0, grueneisen = 2.0 }\n"
    "strength = { model = 'perfectly-plastic', shear_modulus = '27.6 GPa', yield_stress = '0.3 GPa' }\n"
    "[material.plate]\ndensity = 2785.0\n"
    "eos = { model = 'mie-grueneisen', bulk_sound_speed = 5328.0, hugoniot_slope = 1.338, grueneisen = 2.0 }\n"
    "strength = { model = 'johnson-cook', shear_modulus = '27.6 GPa', a = '265 MPa', b = '426 MPa', n = 0.34, c = "
    "0.015, "
    "m = 1.0, melting_temperature = '775 K', specific_heat = '875 J/(kg K)' }\n";

}  // namespace tektite::test
