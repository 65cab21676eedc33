// The exact solution that the collapsing ring is compared with.
#include <catch2/catch.hpp>

#include "support/ring.hpp"

using namespace tektite;

TEST_CASE("Collapsing ring: the exact motion stops at the published radii, its energy spent", "[ring]") {
  test::Ring ring{1845.0, 330e6, 0.08, 0.1, 417.1};
  ring.advance_to(200e-6);
  CHECK(ring.speed == 0.0);
  CHECK(ring.inner == Approx(0.0500).margin(0.5e-4));  // as printed, to 0.1 mm
  CHECK(ring.outer == Approx(0.0781).margin(0.5e-4));

  // ∫∫ Y dε dA over the ring: a particle that goes from r0 to r strains by 2/√3 ln(r0/r).
  constexpr int rings = 10000;
  double work = 0.0;
  for (int k = 0; k < rings; ++k) {
    const double square = 0.0064 + (k + 0.5) * 0.0036 / rings;
    const double now = square - 0.0064 + ring.inner * ring.inner;
    work += 330e6 * M_PI * 0.0036 / rings * 2.0 / std::sqrt(3.0) * 0.5 * std::log(square / now);
  }
  const double kinetic = M_PI * 1845.0 * 417.1 * 417.1 * 0.0064 * std::log(0.1 / 0.08);
  CHECK(work == Approx(kinetic).epsilon(1e-4));  // the sum over rings: (1/10000)² and the last step's size
}
