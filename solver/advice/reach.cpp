#include "advice/reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "parallel/body_mean.hpp"

namespace tektite {
namespace {

/// Particles of a body that may go before it is worth a word.
constexpr double worth_a_word = 0.05;

struct Extent {
  std::vector<double> lower, upper;
};

Extent nothing(std::size_t width) {
  const double infinite = std::numeric_limits<double>::infinity();
  return {std::vector<double>(width, infinite), std::vector<double>(width, -infinite)};
}

void widen(Extent& extent, const double* x) {
  for (std::size_t k = 0; k < extent.lower.size(); ++k) {
    extent.lower[k] = std::min(extent.lower[k], x[k]);
    extent.upper[k] = std::max(extent.upper[k], x[k]);
  }
}

Extent extent_of(const Particles& particles, const Body& body) {
  const auto width = static_cast<std::size_t>(particles.dimensions());
  auto extent = nothing(width);
  for (std::size_t i = body.range.begin; i < body.range.end; ++i)
    widen(extent, particles.reals(Field::position).data() + i * width);
  return extent;
}

double distance(const Extent& extent, const double* x) {
  double square = 0.0;
  for (std::size_t k = 0; k < extent.lower.size(); ++k) {
    const double out = std::max({0.0, extent.lower[k] - x[k], x[k] - extent.upper[k]});
    square += out * out;
  }
  return std::sqrt(square);
}

/// Whether nothing happens in a body by itself: it moves as one, and is neither pressed nor heated anywhere.
bool starts_quiet(const Particles& particles, const Body& body, double density_at_rest) {
  const auto width = static_cast<std::size_t>(particles.dimensions());
  const auto velocity = particles.reals(Field::velocity);
  const bool energetic = particles.has(Field::specific_internal_energy);
  for (std::size_t i = body.range.begin; i < body.range.end; ++i) {
    for (std::size_t k = 0; k < width; ++k)
      if (velocity[i * width + k] != velocity[body.range.begin * width + k]) return false;
    if (energetic && particles.reals(Field::specific_internal_energy)[i] != 0.0) return false;
    if (particles.reals(Field::density)[i] != density_at_rest) return false;
  }
  return true;
}

/// The fastest of all waves, shocks and bodies, m/s: what slides along a body must not outrun what it sends into it.
double fastest(const Particles& particles, const RunSettings& settings, const std::vector<Meeting>& meetings) {
  double speed = 0.0;
  for (const auto& body : particles.bodies())
    speed = std::max(speed, wave_speed_at_rest(settings.materials.at(body.material)));
  for (const auto& meeting : meetings) {
    speed = std::max(speed, meeting.closing_speed);
    if (meeting.shocked)
      speed = std::max({speed, meeting.shocked->first.shock_speed, meeting.shocked->second.shock_speed});
  }
  return speed;
}

/// The box of whole cells about what lies within `reach` of `source`.
Extent reached_box(const Particles& particles, const Body& body, const Extent& source, double reach) {
  const auto width = static_cast<std::size_t>(particles.dimensions());
  auto box = nothing(width);
  for (std::size_t i = body.range.begin; i < body.range.end; ++i) {
    const auto* x = particles.reals(Field::position).data() + i * width;
    if (distance(source, x) <= reach) widen(box, x);
  }
  for (std::size_t k = 0; k < width; ++k) {
    box.lower[k] -= 0.5 * body.spacing;
    box.upper[k] += 0.5 * body.spacing;
  }
  return box;
}

}  // namespace

std::vector<Trim> unreached(const Particles& particles, const RunSettings& settings,
                            const std::vector<Meeting>& meetings) {
  std::vector<Trim> trims;
  if (meetings.empty()) return trims;
  const auto width = static_cast<std::size_t>(particles.dimensions());
  const double speed = fastest(particles, settings, meetings);
  const auto quiet = [&](const Body& body) {
    return starts_quiet(particles, body, settings.materials.at(body.material).density);
  };
  for (const auto& body : particles.bodies()) {
    if (!quiet(body)) continue;
    const auto velocity = mean_over(particles, body, Field::velocity);
    auto source = nothing(width);
    double gap = 0.0;
    for (const auto& other : particles.bodies()) {
      if (quiet(other) && mean_over(particles, other, Field::velocity) == velocity) continue;
      const auto extent = extent_of(particles, other);
      widen(source, extent.lower.data());
      widen(source, extent.upper.data());
    }
    if (!(source.lower[0] <= source.upper[0])) continue;
    if (settings.from_contact) {
      const auto own = extent_of(particles, body);
      double square = 0.0;
      for (std::size_t k = 0; k < width; ++k)
        square += std::pow(std::max({0.0, source.lower[k] - own.upper[k], own.lower[k] - source.upper[k]}), 2);
      gap = std::sqrt(square);
    }
    const double kernel = 2.0 * particles.reals(Field::smoothing_length)[body.range.begin];
    const double reach = gap + speed * settings.end + kernel;
    const auto box = reached_box(particles, body, source, reach);
    if (!(box.lower[0] <= box.upper[0])) continue;
    std::size_t outside = 0;
    for (std::size_t i = body.range.begin; i < body.range.end; ++i)
      outside += distance(box, particles.reals(Field::position).data() + i * width) > 0.0;
    if (static_cast<double>(outside) > worth_a_word * static_cast<double>(body.range.size()))
      trims.push_back({&body, box.lower, box.upper, outside, reach});
  }
  return trims;
}

}  // namespace tektite
