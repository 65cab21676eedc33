#include "run/misfit.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "run/particle_room.hpp"
#include "support/lattice.hpp"

using namespace tektite;

namespace {

constexpr double d = 1e-3;

Particles sheet(Space space, std::vector<double> first) {
  return test::particles_on(space, {{"body", "metal", d, std::move(first), {20, 20}, {0.0, 0.0}}}, 2785.0);
}

}  // namespace

TEST_CASE("Density misfit: rings that have widened have the room of their section") {
  auto particles = sheet(Space::axisymmetric, {20.0 * d, 0.0});
  constexpr double stretch = 1.9;  // along themselves; the section is as it was
  particles.allocate(Field::thickness);
  for (std::size_t i = 0; i < particles.count(); ++i) {
    particles.scalars(Field::thickness)[i] = stretch;
    particles.scalars(Field::mass)[i] *= 2.0 * std::numbers::pi * particles.vectors<2>(Field::position)[i][0];
  }
  const auto& body = particles.bodies().front();
  CHECK(room_of(particles, body, 0) == Approx(d * d).epsilon(1e-12));
  CHECK(misfit(particles, body).part == 0.0);
}

TEST_CASE("Density misfit: a sheet in plane stress that has become thinner has the room of its plane") {
  auto particles = sheet(Space::plane_stress, {0.0, 0.0});
  constexpr double thickness = 0.6;
  particles.allocate(Field::thickness);
  std::ranges::fill(particles.reals(Field::thickness), thickness);
  for (auto& mass : particles.reals(Field::mass)) mass *= thickness;
  const auto& body = particles.bodies().front();
  CHECK(room_of(particles, body, 0) == Approx(d * d).epsilon(1e-12));
  CHECK(misfit(particles, body).part == 0.0);
}
