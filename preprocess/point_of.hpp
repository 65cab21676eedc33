#pragma once

#include "core/particles.hpp"
#include "preprocess/geometry/placement.hpp"

namespace tektite::preprocess {

/// Where a particle is.
inline Point point_of(const Particles& particles, std::size_t particle) {
  const auto d = static_cast<std::size_t>(particles.dimensions());
  const auto positions = particles.reals(Field::position);
  Point x{};
  for (std::size_t k = 0; k < d; ++k) x[static_cast<int>(k)] = positions[particle * d + k];
  return x;
}

}  // namespace tektite::preprocess
