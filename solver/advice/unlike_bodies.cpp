#include "advice/unlike_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tektite {
namespace {

/// The largest Courant number with the speed √(L/ρ) of the stiff body's L and the light one's ρ; that of one body alone
/// (docs/stability.md). Bodies with a ratio of 30, 100 and 300 in density and stiffness were stable up to 1.5, 1.4 and
/// 1.2 and ran away at 2.2, 2.0 and 1.7.
constexpr double largest_courant = 1.0;

struct Side {
  const Body* body;
  double density, wave_speed, smoothing_length;
  double stiffness() const { return density * wave_speed * wave_speed; }
};

Side side_of(const Particles& particles, const Body& body, const RunSettings& settings) {
  const auto& material = settings.materials.at(body.material);
  return {&body, material.density, wave_speed_at_rest(material),
          particles.reals(Field::smoothing_length)[body.range.begin]};
}

}  // namespace

std::vector<std::string> unlike_bodies(const Particles& particles, const RunSettings& settings,
                                       const std::vector<Meeting>& meetings) {
  std::vector<std::string> lines;
  if (settings.scheme.type != "eulerian" || settings.scheme.contact) return lines;
  for (const auto& meeting : meetings) {
    auto light = side_of(particles, *meeting.first, settings), stiff = side_of(particles, *meeting.second, settings);
    if (light.stiffness() / stiff.density > stiff.stiffness() / light.density) std::swap(light, stiff);
    const double step = settings.scheme.courant *
                        std::min(light.smoothing_length / light.wave_speed, stiff.smoothing_length / stiff.wave_speed);
    const double courant =
        step * std::sqrt(stiff.stiffness() / light.density) / std::min(light.smoothing_length, stiff.smoothing_length);
    if (!(courant > largest_courant)) continue;
    lines.push_back(fmt::format(
        "{} and {}: kernel sums join them, and steps that suit the waves of each are {:.2g} times as long as the "
        "stiffness of {} beside the density of {} stands: motion may grow there out of nothing (energy-runaway); "
        "[contact] or scheme.courant = {:.2g} mends it",
        meeting.first->name, meeting.second->name, courant / largest_courant, stiff.body->name, light.body->name,
        settings.scheme.courant * largest_courant / courant));
  }
  return lines;
}

}  // namespace tektite
