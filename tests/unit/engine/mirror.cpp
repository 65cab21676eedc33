// Images behind symmetry planes.

#include "boundary/mirror.hpp"

#include <catch2/catch.hpp>

using namespace tektite;

TEST_CASE("Mirror: records have room for all images and no more, however many there were before") {
  constexpr std::size_t count = 100;
  Mirror<1> mirror({SymmetryPlane{0, 0.0, 1.0}});
  std::vector<double> records;
  for (const double reach : {2.5, 3.5, 4.5}) {
    std::vector<Vector<double, 1>> places;
    for (std::size_t i = 0; i < count; ++i) places.push_back({static_cast<double>(i) + 0.25});
    mirror.find(places, reach);
    REQUIRE(mirror.images() == static_cast<std::size_t>(reach + 0.75));
    mirror.fit(records, count);
    CHECK(records.size() == count + mirror.images());
    CHECK(records.capacity() == records.size());
    std::vector<double> repeated(count);
    mirror.repeat(repeated);
    CHECK(repeated.size() == records.size());
    CHECK(repeated.capacity() == repeated.size());
  }
}
