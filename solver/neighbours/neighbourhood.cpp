#include "neighbours/neighbourhood.hpp"

#include <algorithm>
#include <limits>

#include "parallel/reduce.hpp"
#include "passes/displacement_box.hpp"

namespace tektite {
namespace {

/// Skin as a part of the support: a thicker one makes lists live longer and hold more that is not near. 0.2 was the
/// fastest of 0.1 to 0.5 on the hvi_2d example; the answer does not depend on it beyond round-off.
constexpr double skin_fraction = 0.2;

/// The skin has to outlast at least this many half steps at the present speeds.
constexpr double least_half_steps = 4.0;

}  // namespace

template <int D>
Neighbourhood<D>::Neighbourhood(Particles& particles, double support, std::vector<SymmetryPlane> planes)
    : particles_(particles), support_(support), mirror_(std::move(planes)) {}

/// By how much two particles may have come nearer since the last search, at the middle of a step dt.
template <int D>
double Neighbourhood<D>::closest_approach(double dt) const {
  const Particles& particles = particles_;
  const DisplacementBox<D> pass{particles.vectors<D>(Field::position), particles.vectors<D>(Field::velocity),
                                particles.vectors<D>(Field::acceleration), particles.vectors<D>(Field::search_position),
                                0.5 * dt};
  const auto box = reduce(particles.count(), typename DisplacementBox<D>::Box{}, pass, DisplacementBox<D>::join);
  double square = 0.0;
  for (int k = 0; k < D; ++k) {
    double width = box.upper[k] - box.lower[k];
    for (const auto& plane : mirror_.planes())
      if (plane.axis == k) width = 2.0 * std::max(std::abs(box.upper[k]), std::abs(box.lower[k]));
    square += width * width;
  }
  return std::sqrt(square);
}

template <int D>
bool Neighbourhood<D>::prepare(double dt) {
  if (reach_ > 0.0 && closest_approach(dt) <= reach_ - support_) return false;
  sort();
  const auto positions = particles_.reals(Field::position);
  std::copy(positions.begin(), positions.end(), particles_.reals(Field::search_position).begin());
  reach_ = support_ + std::max(skin_fraction * support_, least_half_steps * closest_approach(dt));
  list();
  return true;
}

template <int D>
void Neighbourhood<D>::restore(double reach) {
  reach_ = reach;
  list();
}

/// Orders each body's particles by cell; within a cell they keep their order.
template <int D>
void Neighbourhood<D>::sort() {
  const auto* x = particles_.vectors<D>(Field::position);
  std::vector<std::uint32_t> order(particles_.count());
  CellGrid<D> grid;
  for (const auto& body : particles_.bodies()) {
    grid.build({x + body.range.begin, body.range.size()}, support_);
    std::size_t next = body.range.begin;
    for (std::size_t cell = 0; cell < grid.cells(); ++cell)
      for (const auto i : grid.members(cell)) order[next++] = static_cast<std::uint32_t>(body.range.begin + i);
  }
  if (!std::is_sorted(order.begin(), order.end())) particles_.permute(order);
}

template <int D>
void Neighbourhood<D>::list() {
  const auto* x = particles_.vectors<D>(Field::search_position);
  places_.assign(x, x + particles_.count());
  mirror_.find(places_, reach_);
  grid_.build(places_, reach_);
  pairs_.build<D>(grid_, places_, particles_.count(), reach_);
}

template <int D>
std::size_t Neighbourhood<D>::memory() const {
  return pairs_.memory() + places_.size() * (sizeof(places_[0]) + 2 * sizeof(std::uint32_t));
}

template class Neighbourhood<1>;
template class Neighbourhood<2>;
template class Neighbourhood<3>;

}  // namespace tektite
