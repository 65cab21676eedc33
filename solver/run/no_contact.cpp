#include "run/no_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "output/progress.hpp"
#include "parallel/reduce.hpp"

namespace tektite {
namespace {

/// The edges of the box about a body's particles, with a support about each.
struct Box {
  std::array<double, 3> lower, upper;

  Box() {
    lower.fill(std::numeric_limits<double>::infinity());
    upper.fill(-std::numeric_limits<double>::infinity());
  }
  static void join(Box& whole, const Box& part) {
    for (std::size_t k = 0; k < 3; ++k) {
      whole.lower[k] = std::min(whole.lower[k], part.lower[k]);
      whole.upper[k] = std::max(whole.upper[k], part.upper[k]);
    }
  }
  bool overlaps(const Box& other) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (lower[k] > other.upper[k] || other.lower[k] > upper[k]) return false;
    return true;
  }
};

Box box_about(const Particles& particles, const Body& body) {
  constexpr double support = 2.0;  // of every kernel
  const auto dimensions = static_cast<std::size_t>(particles.dimensions());
  const auto position = particles.reals(Field::position), h = particles.reals(Field::smoothing_length);
  return reduce(
      particles, body.range, Box(),
      [=](Box& so_far, std::size_t i) {
        const double reach = 0.5 * support * h[i];  // half of it from either body
        Box own;
        own.lower.fill(-reach), own.upper.fill(reach);
        for (std::size_t k = 0; k < dimensions; ++k) {
          own.lower[k] += position[i * dimensions + k];
          own.upper[k] += position[i * dimensions + k];
        }
        Box::join(so_far, own);
      },
      Box::join);
}

}  // namespace

std::optional<Warning> no_contact(const Simulation& simulation) {
  const auto& particles = simulation.particles();
  if (particles.bodies().size() < 2 || simulation.contact_time()) return std::nullopt;
  std::vector<Box> boxes;
  for (const auto& body : particles.bodies()) {
    const auto box = box_about(particles, body);
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
