#include "neighbours/compress.hpp"

#include <catch2/catch.hpp>
#include <random>
#include <vector>

using namespace tektite;

TEST_CASE("Compress: the marked ones are kept, in their order, for every pattern of eight") {
  std::vector<std::uint32_t> values(2 * 256 * compress_width), kept;
  std::vector<std::uint8_t> mark(values.size());
  std::mt19937 random(7);
  for (std::size_t n = 0; n < values.size(); ++n) {
    values[n] = static_cast<std::uint32_t>(random());
    const std::size_t eight = n / compress_width;  // every pattern once, then at random
    mark[n] = eight < 256 ? eight >> (n % compress_width) & 1u : random() & 1u;
    if (mark[n] != 0) kept.push_back(values[n]);
  }
  std::vector<std::uint32_t> out(values.size());
  out.resize(compress(values, mark, out));
  CHECK(out == kept);
}
