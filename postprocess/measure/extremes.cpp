// Largest value of a field in the last snapshot.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "postprocess/measure/measure.hpp"

namespace tektite {
namespace {

/// A single particle stands for a cell of one spacing, over which the field varies: the uncertainty is the difference
/// between the largest value and the mean of those within one smoothing length of it in the same body.
Measured largest(const Event& event, const std::string& body_name, Field field) {
  const auto& particles = event.last_snapshot.particles;
  if (!particles.has(field)) throw RunError(fmt::format("the last snapshot has no {}", info(field).name));
  const auto values = particles.reals(field).first(particles.count());
  const auto& body = event.last.bodies[static_cast<std::size_t>(event.last.body_named(body_name))];
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(body.range.begin);
  const auto last = values.begin() + static_cast<std::ptrdiff_t>(body.range.end);
  const auto at = static_cast<std::size_t>(std::max_element(first, last) - values.begin());
  double sum = 0.0;
  std::size_t count = 0;
  for (auto i = body.range.begin; i < body.range.end; ++i) {
    if (norm(event.last.position[i] - event.last.position[at]) > event.last.smoothing_length[at]) continue;
    sum += values[i];
    ++count;
  }
  return {values[at], event.last.time, values[at] - sum / static_cast<double>(count), {}};
}

Measure read_largest(Section& section, const Declared& declared, Field field) {
  const auto body = read_body(section, "body", declared);
  return [=](const Event& event) { return largest(event, body, field); };
}

}  // namespace

Measure read_max_plastic_strain(Section& section, const Declared& declared) {
  return read_largest(section, declared, Field::plastic_strain);
}

Measure read_max_temperature(Section& section, const Declared& declared) {
  return read_largest(section, declared, Field::temperature);
}

}  // namespace tektite
