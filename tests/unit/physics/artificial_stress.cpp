#include "physics/artificial_stress.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace tektite;

namespace {

struct Plane {
  double xx, yy, xy;
};

Plane artificial(const Plane& stress, double density) {
  const double components[3] = {stress.xx, stress.yy, stress.xy};
  double r[3];
  ArtificialStress{}.tensor(components, density, r);
  return {r[0], r[1], r[2]};
}

/// The stress with these principal values along an axis at this angle to x.
Plane principal(double first, double second, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {first * c * c + second * s * s, first * s * s + second * c * c, (first - second) * c * s};
}

}  // namespace

TEST_CASE("Artificial stress: compression has none, whatever its direction") {
  for (const double angle : {0.0, 0.4, 1.3}) {
    const auto r = artificial(principal(-1e9, -3e9, angle), 2785.0);
    CHECK(r.xx == 0.0);
    CHECK(r.yy == 0.0);
    CHECK(r.xy == 0.0);
  }
}

TEST_CASE(
    "Artificial stress: each tensile principal stress is answered along its own axis by -0.3 of it over density "
    "squared") {
  for (const double angle : {0.0, 0.4, 1.3, std::numbers::pi / 2})
    for (const double second : {2e8, -5e8}) {
      const auto r = artificial(principal(1e9, second, angle), 2.0);
      const auto wanted = principal(-0.3 * 1e9 / 4.0, -0.3 * std::fmax(second, 0.0) / 4.0, angle);
      CHECK(r.xx == Approx(wanted.xx).margin(1e-6));  // rounding of 1e8
      CHECK(r.yy == Approx(wanted.yy).margin(1e-6));
      CHECK(r.xy == Approx(wanted.xy).margin(1e-6));
    }
}

TEST_CASE("Artificial stress: equal tension on all sides needs no direction") {
  const auto r = artificial({1.0, 1.0, 0.0}, 1.0);
  CHECK(r.xx == Approx(-0.3));
  CHECK(r.yy == Approx(-0.3));
  CHECK(r.xy == 0.0);
}
