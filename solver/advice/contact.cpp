#include "advice/contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "advice/flow_stress.hpp"
#include "parallel/body_mean.hpp"

namespace tektite {
namespace {

/// Of a body from its outermost particle to that on the other side, along a direction that need not have the length 1.
double length_along(const Particles& particles, const Body& body, const std::array<double, 3>& direction) {
  const auto position = particles.reals(Field::position);
  const auto d = static_cast<std::size_t>(particles.dimensions());
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (auto i = body.range.begin; i < body.range.end; ++i) {
    double at = 0.0;
    for (std::size_t k = 0; k < d; ++k) at += direction[k] * position[d * i + k];
    least = std::min(least, at);
    most = std::max(most, at);
  }
  return (most - least) / std::hypot(direction[0], direction[1], direction[2]) + body.spacing;
}

bool flows(const Material& material, double stress) {
  const auto flow = flow_stress(material, 0.0);
  return flow && stress > *flow;
}

/// Whether the acoustic stress, of Z_a Z_b/(Z_a + Z_b) times the closing speed, makes one of both flow.
bool flows(const Meeting& meeting, const RunSettings& settings) {
  const auto &a = settings.materials.at(meeting.first->material), &b = settings.materials.at(meeting.second->material);
  const double yielding = 1.0 / (a.density * wave_speed_at_rest(a)) + 1.0 / (b.density * wave_speed_at_rest(b));
  return flows(a, meeting.closing_speed / yielding) || flows(b, meeting.closing_speed / yielding);
}

}  // namespace

std::vector<std::string> slow_contacts(const Particles& particles, const RunSettings& settings,
                                       const std::vector<Meeting>& meetings) {
  std::vector<std::string> lines;
  if (!settings.scheme.contact || settings.scheme.contact->at_faces) return lines;
  constexpr double support = 2.0;  // of every kernel that bodies in contact may have
  for (const auto& meeting : meetings) {
    auto direction = mean_over(particles, *meeting.first, Field::velocity);
    const auto other = mean_over(particles, *meeting.second, Field::velocity);
    for (std::size_t k = 0; k < direction.size(); ++k) direction[k] -= other[k];
    double crossing = std::numeric_limits<double>::infinity(), reach = 0.0, spacing = 0.0;
    for (const Body* body : {meeting.first, meeting.second}) {
      const auto& material = settings.materials.at(body->material);
      const double speed = wave_speed_at_rest(material);
      crossing = std::min(crossing, 2.0 * length_along(particles, *body, direction) / speed);
      reach += 0.5 * support * particles.reals(Field::smoothing_length)[body->range.begin];
      spacing += 0.5 * body->spacing;
    }
    const double way = std::min(reach, meeting.gap) - spacing;
    if (way <= meeting.closing_speed * crossing || flows(meeting, settings)) continue;
    lines.push_back(fmt::format(
        "{} and {}: from where their kernels meet to where their faces touch it takes {:.2g} s at {:.3g} m/s, and "
        "waves "
        "through the shorter one and back {:.2g} s; the contact is softer than the bodies, which part late and as "
        "rigid "
        "ones do; contact.begins = 'at-faces' mends it",
        meeting.first->name, meeting.second->name, way / meeting.closing_speed, meeting.closing_speed, crossing));
  }
  return lines;
}

std::vector<std::string> rough_contacts(const Particles& particles, const RunSettings& settings,
                                        const std::vector<Meeting>& meetings) {
  std::vector<std::string> lines;
  const auto& scheme = settings.scheme;
  if (!scheme.contact || scheme.type != "total-lagrangian" || scheme.hourglass_control > 0.0 ||
      particles.dimensions() == 1)
    return lines;
  for (const auto& meeting : meetings)
    if (!flows(meeting, settings))
      lines.push_back(fmt::format(
          "{} and {} meet elastically: where their particles do not lie opposite each other, as on round faces, they "
          "shove each other aside, and what they lose does not come back (docs/stability.md); "
          "scheme.hourglass_control = 0.05 to 0.2 holds them",
          meeting.first->name, meeting.second->name));
  return lines;
}

}  // namespace tektite
