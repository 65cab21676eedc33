#include "parallel/threads.hpp"

#include <catch2/catch.hpp>

namespace tektite {

TEST_CASE("Threads: each has five hundred particles, unless a number of them is asked for") {
  const int before = threads_in_use();
  use_threads(3);
  CHECK(threads_in_use() == 3);
  use_threads(0);
  CHECK(threads_in_use() == 3);
  use_threads(0, 10'000'000);
  CHECK(threads_in_use() == 3);
  use_threads(0, 1499);
  CHECK(threads_in_use() == 2);
  use_threads(0, 0);
  CHECK(threads_in_use() == 1);
  use_threads(4, 10);
  CHECK(threads_in_use() == 4);
  use_threads(before);
}

}  // namespace tektite
