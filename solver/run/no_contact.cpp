#include "run/no_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "output/progress.hpp"

namespace tektite {
namespace {

/// The edges of the box about a body's particles, with a support about each.
struct Box {
  std::vector<double> lower, upper;

  Box(const Particles& particles, const Body& body)
      : lower(static_cast<std::size_t>(particles.dimensions()), std::numeric_limits<double>::infinity()),
        upper(lower.size(), -std::numeric_limits<double>::infinity()) {
    constexpr double support = 2.0;  // of every kernel
    const auto position = particles.reals(Field::position);
    const auto h = particles.reals(Field::smoothing_length);
    for (std::size_t i = body.range.begin; i < body.range.end; ++i)
      for (std::size_t k = 0; k < lower.size(); ++k) {
        const double x = position[i * lower.size() + k], reach = 0.5 * support * h[i];  // half of it from either body
        lower[k] = std::min(lower[k], x - reach);
        upper[k] = std::max(upper[k], x + reach);
      }
  }
  bool overlaps(const Box& other) const {
    for (std::size_t k = 0; k < lower.size(); ++k)
      if (lower[k] > other.upper[k] || other.lower[k] > upper[k]) return false;
    return true;
  }
};

}  // namespace

std::optional<Warning> no_contact(Simulation& simulation) {
  const auto& particles = simulation.whole();
  if (particles.bodies().size() < 2 || simulation.contact_time()) return std::nullopt;
  std::vector<Box> boxes;
  for (const auto& body : particles.bodies()) {
    const Box box(particles, body);
    if (std::ranges::any_of(boxes, [&](const Box& other) { return box.overlaps(other); })) return std::nullopt;
    boxes.push_back(box);
  }
  return Warning{
      "no-contact",
      fmt::format("no two of the {} bodies have met until t = {}: a later time.end, a smaller gap or another "
                  "direction of the velocities may bring them together",
                  boxes.size(), shown_time(simulation.time()))};
}

}  // namespace tektite
