#include "run/too_near.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "neighbours/cell_grid.hpp"
#include "parallel/reduce.hpp"
#include "run/lagrangian.hpp"
#include "run/particle_room.hpp"

namespace tektite {
namespace {

/// Particles with the distance below which another one is too near.
template <int D>
struct Crowd {
  std::vector<std::size_t> members;
  std::vector<Vector<double, D>> x;
  std::vector<double> near;  ///< m

  void add(const Particles& particles, const Body& body, std::size_t i) {
    members.push_back(i);
    x.push_back(particles.vectors<D>(Field::position)[i]);
    near.push_back(too_near_distance * spacing_of(particles, body, i));
  }
};

/// How many of those that asks(i), on all ranks, have one too near with which i meets(i, j).
template <int D, class Asks, class Meets>
std::size_t count_too_near(const Particles& particles, const Crowd<D>& crowd, const Asks& asks, const Meets& meets) {
  CellGrid<D> grid;
  if (!crowd.members.empty()) grid.build(crowd.x, *std::ranges::max_element(crowd.near));
  const auto too_near = [&](std::size_t n) {
    for (const auto cell : grid.around(grid.cell_of(crowd.x[n])))
      for (const auto m : grid.members(cell))
        if (m != n && norm(crowd.x[m] - crowd.x[n]) < std::min(crowd.near[m], crowd.near[n]) &&
            meets(crowd.members[n], crowd.members[m]))
          return true;
    return false;
  };
  const auto add = [](std::size_t& whole, std::size_t part) { whole += part; };
  const auto own = reduce(
      crowd.x.size(), std::size_t{0},
      [&, counts = Owned(particles)](std::size_t& count, std::size_t n) {
        const auto i = crowd.members[n];
        count += counts(i) && asks(i) && too_near(n) ? 1 : 0;
      },
      add);
  return over_ranks(particles, own, add);
}

template <int D>
std::size_t count_clumped(const Particles& particles, const Body& body) {
  Crowd<D> crowd;
  for (auto i = body.range.begin; i < body.range.end; ++i)
    if (!is_lagrangian(particles, i)) crowd.add(particles, body, i);
  return count_too_near(
      particles, crowd, [](std::size_t) { return true; }, [](std::size_t, std::size_t) { return true; });
}

template <int D>
std::size_t count_interpenetrated(const Particles& particles, const Body& own) {
  if (particles.bodies().size() == 1 && !particles.has(Field::reference_position)) return 0;
  const auto within = [&own](std::size_t i) { return i >= own.range.begin && i < own.range.end; };
  Crowd<D> crowd;
  for (const auto& body : particles.bodies())
    for (auto i = body.range.begin; i < body.range.end; ++i) crowd.add(particles, body, i);
  return count_too_near(particles, crowd, within, [&](std::size_t i, std::size_t j) {
    if (!within(j)) return true;
    if (!is_lagrangian(particles, i) || !is_lagrangian(particles, j)) return false;
    const auto* places = particles.vectors<D>(Field::reference_position);
    return norm(places[i] - places[j]) > 2.0 * own.spacing;
  });
}

double part_of(std::size_t count, const Particles& particles, const Body& body) {
  const auto all = size_of(particles, body);
  return all == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(all);
}

}  // namespace

double clumped_part(const Particles& particles, const Body& body) {
  const auto count = particles.dimensions() == 1   ? count_clumped<1>(particles, body)
                     : particles.dimensions() == 2 ? count_clumped<2>(particles, body)
                                                   : count_clumped<3>(particles, body);
  return part_of(count, particles, body);
}

double interpenetrated_part(const Particles& particles, const Body& body) {
  const auto count = particles.dimensions() == 1   ? count_interpenetrated<1>(particles, body)
                     : particles.dimensions() == 2 ? count_interpenetrated<2>(particles, body)
                                                   : count_interpenetrated<3>(particles, body);
  return part_of(count, particles, body);
}

double beyond_planes_part(const Particles& particles, const Body& body, std::span<const SymmetryPlane> planes) {
  const auto d = static_cast<std::size_t>(particles.dimensions());
  const auto position = particles.reals(Field::position);
  const auto count = count_over(particles, body.range, [&](std::size_t i) {
    return std::ranges::any_of(planes, [&](const SymmetryPlane& plane) {
      return plane.side * (position[d * i + static_cast<std::size_t>(plane.axis)] - plane.at) < 0.0;
    });
  });
  return part_of(count, particles, body);
}

}  // namespace tektite
