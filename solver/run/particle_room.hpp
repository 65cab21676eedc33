#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/particles.hpp"
#include "core/space.hpp"

namespace tektite {

/// The length, area or volume in m^D that a particle has among its neighbours by mass and density: of a ring its
/// section, of a shell its thickness. In plane stress the thickness of the sheet is divided out; that of rings is how
/// far they have been stretched along themselves, which their radius tells too. On an axis, where half a cell lies, the
/// mean radius is a quarter of the spacing.
inline double room_of(const Particles& particles, const Body& body, std::size_t i) {
  double room = particles.scalars(Field::mass)[i] / particles.scalars(Field::density)[i];
  if (particles.space() == Space::plane_stress && particles.has(Field::thickness))
    room /= particles.scalars(Field::thickness)[i];
  const int hoops = hoops_of(particles.space());
  if (hoops == 0) return room;
  const auto d = static_cast<std::size_t>(particles.dimensions());
  const double radius = std::max(std::abs(particles.reals(Field::position)[d * i]), 0.25 * body.spacing);
  return room / (hoops == 1 ? 2.0 * std::numbers::pi * radius : 4.0 * std::numbers::pi * radius * radius);
}

/// The distance in m that a square lattice of such particles has.
inline double spacing_of(const Particles& particles, const Body& body, std::size_t i) {
  return std::pow(room_of(particles, body, i), 1.0 / particles.dimensions());
}

}  // namespace tektite
