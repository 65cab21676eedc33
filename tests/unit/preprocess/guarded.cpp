// What CGAL itself finds wrong.
#include <catch2/catch.hpp>

#include "preprocess/geometry/surface_mesh.hpp"
#include "support/fault.hpp"

using namespace tektite;

TEST_CASE("CGAL: what it finds violated is told with what was being done") {
  CHECK(test::fault_of([] {
          preprocess::guarded("two cubes cannot be joined",
                              [] { CGAL::precondition_fail("is_closed(cube)", "cube.h", 1, "it has a hole"); });
        }) == "two cubes cannot be joined: is_closed(cube)");
}
