// The section of a ring near the axis: whole where it fits, folded where it would reach beyond.
#include <catch2/catch.hpp>

#include "passes/ring_section.hpp"

using namespace tektite;

TEST_CASE("Ring section: the innermost cell of a lattice is the first that is not folded") {
  constexpr double spacing = 1e-3;
  const auto volume = [](double radius) { return 2.0 * M_PI * radius * spacing * spacing; };
  for (const double cells : {0.5, 1.0, 7.5}) {
    const auto ring = section_of_ring(cells * spacing, volume(cells * spacing) * (1.0 - 1e-12));
    CHECK(ring.mean_radius == Approx(cells * spacing).epsilon(1e-12));
    CHECK(ring.share == Approx(1.0).epsilon(1e-11));
    CHECK(std::abs(ring.arm) < 1e-11 * spacing);
  }
}

TEST_CASE("Ring section: a folded square has the volume, and a linear motion its rate") {
  constexpr double volume = 3e-9;
  const double whole = std::cbrt(volume / (8.0 * M_PI));  // the radius from which on nothing is folded
  double area = 0.0;
  for (const double part : {1e-9, 0.01, 0.3, 0.7, 1.0 - 1e-9}) {
    const double radius = part * whole;
    const auto ring = section_of_ring(radius, volume);
    const double w = radius / ring.share;
    CHECK(2.0 * M_PI * ring.mean_radius * 4.0 * w * w == Approx(volume).epsilon(1e-12));
    // v_r = r: v_r itself and its slope, 1, make up the mean radius.
    CHECK(ring.share * radius + ring.arm == Approx(ring.mean_radius).epsilon(1e-12));
    // The section grows without a jump toward the axis, by no more than 4^(1/3).
    if (area > 0.0) CHECK(4.0 * w * w < area);
    area = 4.0 * w * w;
    CHECK(area < std::cbrt(4.0) * 4.0 * whole * whole * (1.0 + 1e-9));
  }
}
