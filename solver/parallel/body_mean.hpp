#pragma once

#include <array>

#include "parallel/sums.hpp"

namespace tektite {

/// Mean of a vector field over a body by mass, on all ranks, in the field's unit; components that the space has not are
/// zero.
inline std::array<double, 3> mean_over(const Particles& particles, const Body& body, Field field) {
  const auto width = static_cast<std::size_t>(particles.dimensions());
  const auto values = particles.reals(field), mass = particles.reals(Field::mass);
  const auto sums = sum_over<4>(particles, body.range, [=](std::size_t i) {
    std::array<double, 4> terms{};
    for (std::size_t k = 0; k < width; ++k) terms[k] = mass[i] * values[i * width + k];
    terms[3] = mass[i];
    return terms;
  });
  return {sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3]};
}

}  // namespace tektite
