#include "core/body_mean.hpp"

namespace tektite {

std::array<double, 3> mean_over(const Particles& particles, const Body& body, Field field) {
  const auto width = static_cast<std::size_t>(particles.dimensions());
  const auto values = particles.reals(field), mass = particles.reals(Field::mass);
  std::array<double, 3> mean{};
  double whole = 0.0;
  for (std::size_t i = body.range.begin; i < body.range.end; ++i) {
    for (std::size_t k = 0; k < width; ++k) mean[k] += mass[i] * values[i * width + k];
    whole += mass[i];
  }
  for (auto& component : mean) component /= whole;
  return mean;
}

}  // namespace tektite
