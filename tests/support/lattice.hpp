#pragma once
// Particles and runs made by hand: bodies on square lattices, and the solver's own run loop over them.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "run/simulation.hpp"

namespace tektite::test {

/// Smoothing length over spacing where a test asks for no other.
inline constexpr double smoothing_ratio = 1.4;

/// A body whose particles stand at first + k δ, 0 ≤ k < count along each axis.
struct Lattice {
  std::string body;
  std::string material;
  double spacing = 0.0;       ///< δ in m
  std::vector<double> first;  ///< m
  std::vector<int> count;
  std::vector<double> velocity;                                  ///< m/s
  std::function<bool(const double* position)> inside = nullptr;  ///< everywhere where there is none
  double ratio = smoothing_ratio;
};

/// A disc or ball of `metal` about the origin, with particles within this many spacings; the lattice has one there, or
/// is centred about it, as the whole or half number of spacings says.
inline Lattice ball(int dimensions, double spacing, double radius) {
  const auto d = static_cast<std::size_t>(dimensions);
  const double largest = radius * spacing;
  return {"body",
          "metal",
          spacing,
          std::vector<double>(d, -largest),
          std::vector<int>(d, static_cast<int>(2.0 * radius) + 1),
          std::vector<double>(d, 0.0),
          [=](const double* x) {
            double square = 0.0;
            for (std::size_t k = 0; k < d; ++k) square += x[k] * x[k];
            return square <= largest * largest;
          }};
}

namespace lattice {

inline std::vector<std::vector<double>> places(const Lattice& lattice) {
  const std::size_t d = lattice.first.size();
  std::vector<std::vector<double>> places;
  std::vector<int> index(d, 0);
  while (index[d - 1] < lattice.count[d - 1]) {
    std::vector<double> x(d);
    for (std::size_t k = 0; k < d; ++k) x[k] = lattice.first[k] + index[k] * lattice.spacing;
    if (!lattice.inside || lattice.inside(x.data())) places.push_back(x);
    ++index[0];
    for (std::size_t k = 0; k + 1 < d && index[k] == lattice.count[k]; ++k) {
      index[k] = 0;
      ++index[k + 1];
    }
  }
  return places;
}

}  // namespace lattice

/// Every body at this density in kg/m³, with full masses; ids count through.
inline Particles particles_on(Space space, const std::vector<Lattice>& lattices, double density) {
  std::vector<std::vector<std::vector<double>>> places;
  std::vector<Body> bodies;
  std::size_t count = 0;
  for (const auto& lattice : lattices) {
    places.push_back(lattice::places(lattice));
    bodies.push_back({lattice.body, lattice.material, lattice.spacing, {count, count + places.back().size()}});
    count += places.back().size();
  }
  Particles particles(space, bodies);
  for (const auto field :
       {Field::id, Field::position, Field::velocity, Field::mass, Field::density, Field::smoothing_length})
    particles.allocate(field);
  const auto d = static_cast<std::size_t>(particles.dimensions());
  std::iota(particles.integers(Field::id).begin(), particles.integers(Field::id).end(), 0);
  std::ranges::fill(particles.reals(Field::density), density);
  for (std::size_t b = 0; b < lattices.size(); ++b)
    for (std::size_t i = bodies[b].range.begin; i < bodies[b].range.end; ++i) {
      particles.scalars(Field::mass)[i] = density * std::pow(lattices[b].spacing, particles.dimensions());
      particles.scalars(Field::smoothing_length)[i] = lattices[b].ratio * lattices[b].spacing;
      for (std::size_t k = 0; k < d; ++k) {
        particles.reals(Field::position)[i * d + k] = places[b][i - bodies[b].range.begin][k];
        particles.reals(Field::velocity)[i * d + k] = lattices[b].velocity[k];
      }
    }
  return particles;
}

/// A run from initial particles as tektite-solve makes it; `scene` has at least [material.NAME] and [time].
inline Simulation simulation_of(const std::string& scene, Particles particles) {
  const auto space = std::string(name_of(particles.space()));
  auto document = Document::parse("name = 'test'\nspace = '" + space + "'\n" + scene, "test scene");
  auto settings = read_run_settings(document);
  Snapshot snapshot{std::move(particles), {{"time", 0.0}}, document.text()};
  return Simulation(std::move(snapshot), std::move(settings), false);
}

inline void run_to_the_end(Simulation& simulation) {
  while (!simulation.finished()) simulation.step();
}

inline void take_steps(Simulation& simulation, int steps) {
  for (int k = 0; k < steps; ++k) simulation.step();
}

/// A field in the order of the ids, which does not depend on how the run sorted the particles.
inline std::vector<double> by_id(const Particles& particles, Field field) {
  const auto values = particles.reals(field);
  const auto ids = particles.integers(Field::id);
  const auto width = static_cast<std::size_t>(particles.components(field));
  std::vector<std::size_t> order(ids.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](std::size_t i) { return ids[i]; });
  std::vector<double> sorted;
  for (const auto i : order)
    sorted.insert(sorted.end(), values.begin() + static_cast<std::ptrdiff_t>(i * width),
                  values.begin() + static_cast<std::ptrdiff_t>((i + 1) * width));
  return sorted;
}

}  // namespace tektite::test
