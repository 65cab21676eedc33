#include "run/wall_heating.hpp"

#include <algorithm>
#include <cmath>

#include "run/particle_room.hpp"

namespace tektite {
namespace {

constexpr double even = 0.05;  // how far two layers inside may differ, that neither a shock nor a slope lies there
constexpr double at_wall = 3.0, away = 15.0, further = 20.0, too_far = 25.0;  // in spacings at the wall

/// What a layer of particles holds.
struct Layer {
  double mass = 0.0, energy = 0.0;

  void add(const Particles& particles, std::size_t i) {
    mass += particles.scalars(Field::mass)[i];
    energy += particles.scalars(Field::mass)[i] * particles.scalars(Field::specific_internal_energy)[i];
  }
  double mean() const { return energy / mass; }
};

double heat_at(const Particles& particles, const Body& body, const SymmetryPlane& plane) {
  const auto d = static_cast<std::size_t>(particles.dimensions());
  const auto distance = [&](std::size_t i) {
    return std::abs(particles.reals(Field::position)[d * i + static_cast<std::size_t>(plane.axis)] - plane.at);
  };
  if (body.range.size() == 0) return 1.0;
  std::size_t first = body.range.begin;
  for (auto i = body.range.begin; i < body.range.end; ++i)
    if (distance(i) < distance(first)) first = i;
  const double here = spacing_of(particles, body, first);
  if (distance(first) > here) return 1.0;
  Layer wall, inner, outer;
  for (auto i = body.range.begin; i < body.range.end; ++i) {
    const double spacings = distance(i) / here;
    if (spacings < at_wall) wall.add(particles, i);
    if (spacings > away && spacings < further) inner.add(particles, i);
    if (spacings > further && spacings < too_far) outer.add(particles, i);
  }
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
