// Largest and smallest value of a field in the last snapshot, or in the one nearest to a time.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "postprocess/measure/moment.hpp"

namespace tektite {
namespace {

enum class Extreme { least, largest };

/// A single particle stands for a cell of one spacing, over which the field varies: the uncertainty is the difference
/// between the extreme value and the mean of those within one smoothing length of it in the same body.
Measured extreme(const Snapshot& snapshot, const Whole& whole, const std::string& body_name, Field field,
                 Extreme which) {
  const auto& particles = snapshot.particles;
  require_field(particles, field);
  const auto values = particles.reals(field).first(particles.count());
  const auto& body = whole.bodies[static_cast<std::size_t>(whole.body_named(body_name))];
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(body.range.begin);
  const auto last = values.begin() + static_cast<std::ptrdiff_t>(body.range.end);
  const auto found = which == Extreme::largest ? std::max_element(first, last) : std::min_element(first, last);
  const auto at = static_cast<std::size_t>(found - values.begin());
  if (field == Field::temperature && *found <= 0.0)  // kept beside a body that heats
    throw RunError(fmt::format("the strength of {} does not heat, so it has no temperature", body_name));
  double sum = 0.0;
  std::size_t count = 0;
  for (auto i = body.range.begin; i < body.range.end; ++i) {
    if (norm(whole.position[i] - whole.position[at]) > whole.smoothing_length[at]) continue;
    sum += values[i];
    ++count;
  }
  return {values[at], whole.time, std::abs(values[at] - sum / static_cast<double>(count)), {}};
}

Measure read_extreme(Section& section, const Declared& declared, Field field, Extreme which) {
  const auto body = read_body(section, "body", declared);
  const auto time = read_moment(section);
  const auto take = [=](const Event& event) {
    return measured_at(event, time, {field}, [&](const Snapshot& snapshot, const Whole& whole) {
      return extreme(snapshot, whole, body, field, which);
    });
  };
  return {take, {field}};
}

}  // namespace

Measure read_max_plastic_strain(Section& section, const Declared& declared) {
  return read_extreme(section, declared, Field::plastic_strain, Extreme::largest);
}

Measure read_max_temperature(Section& section, const Declared& declared) {
  return read_extreme(section, declared, Field::temperature, Extreme::largest);
}

Measure read_max_pressure(Section& section, const Declared& declared) {
  return read_extreme(section, declared, Field::pressure, Extreme::largest);
}

/// Negative where the body is under tension somewhere.
Measure read_min_pressure(Section& section, const Declared& declared) {
  return read_extreme(section, declared, Field::pressure, Extreme::least);
}

}  // namespace tektite
