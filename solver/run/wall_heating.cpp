#include "run/wall_heating.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "parallel/reduce.hpp"
#include "parallel/sums.hpp"
#include "run/particle_room.hpp"

namespace tektite {
namespace {

constexpr double even = 0.05;  // how far two layers inside may differ, that neither a shock nor a slope lies there
constexpr double at_wall = 3.0, away = 15.0, further = 20.0, too_far = 25.0;  // in spacings at the wall

/// The particle that is nearest to a wall, of several the one of the least id.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  std::int64_t id = 0;
  double spacing = 0.0;

  static void join(Nearest& whole, const Nearest& part) {
    if (part.distance < whole.distance || (part.distance == whole.distance && part.id < whole.id)) whole = part;
  }
};

/// What a layer of particles holds.
struct Layer {
  double mass, energy;
  double mean() const { return energy / mass; }
};

double heat_at(const Particles& particles, const Body& body, const SymmetryPlane& plane) {
  const auto d = static_cast<std::size_t>(particles.dimensions());
  const auto distance = [&](std::size_t i) {
    return std::abs(particles.reals(Field::position)[d * i + static_cast<std::size_t>(plane.axis)] - plane.at);
  };
  const auto nearest = reduce(
      particles, body.range, Nearest{},
      [&, id = particles.integers(Field::id)](Nearest& so_far, std::size_t i) {
        if (distance(i) <= so_far.distance) Nearest::join(so_far, {distance(i), id[i], spacing_of(particles, body, i)});
      },
      Nearest::join);
  if (!(nearest.distance <= nearest.spacing)) return 1.0;
  const auto sums = sum_over<6>(
      particles, body.range,
      [&, m = particles.scalars(Field::mass), e = particles.scalars(Field::specific_internal_energy)](std::size_t i) {
        const double spacings = distance(i) / nearest.spacing;
        std::array<double, 6> terms{};
        const auto take = [&](std::size_t layer) { terms[2 * layer] = m[i], terms[2 * layer + 1] = m[i] * e[i]; };
        if (spacings < at_wall) take(0);
        if (spacings > away && spacings < further) take(1);
        if (spacings > further && spacings < too_far) take(2);
        return terms;
      });
  const Layer wall{sums[0], sums[1]}, inner{sums[2], sums[3]}, outer{sums[4], sums[5]};
  if (!(inner.energy > 0.0 && outer.energy > 0.0)) return 1.0;
  if (std::abs(inner.mean() - outer.mean()) > even * outer.mean()) return 1.0;
  return wall.mean() / inner.mean();
}

}  // namespace

double heat_at_walls(const Particles& particles, const Body& body, const std::vector<SymmetryPlane>& planes) {
  double largest = 1.0;
  for (const auto& plane : planes) largest = std::max(largest, heat_at(particles, body, plane));
  return largest;
}

}  // namespace tektite
