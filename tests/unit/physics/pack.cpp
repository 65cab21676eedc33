#include "core/pack.hpp"

#include "physics/elementary.hpp"

#include <catch2/catch.hpp>

using namespace tektite;

namespace {

const Pack counting([](int lane) { return lane + 1.0; });  // 1 2 3 4

}  // namespace

TEST_CASE("Packs: each lane is chosen for itself", "[pack]") {
  const Pack chosen = select(counting < Pack(2.5), counting, Pack(-1.0));
  for (int lane = 0; lane < static_cast<int>(pack_width); ++lane)
    CHECK(chosen[lane] == select(counting[lane] < 2.5, counting[lane], -1.0));
}

TEST_CASE("Packs: larger and smaller are those of each lane", "[pack]") {
  const Pack other([](int lane) { return 4.0 - 1.5 * lane; });
  for (int lane = 0; lane < static_cast<int>(pack_width); ++lane) {
    CHECK(larger(counting, other)[lane] == larger(double(counting[lane]), double(other[lane])));
    CHECK(smaller(counting, other)[lane] == smaller(double(counting[lane]), double(other[lane])));
  }
}

TEST_CASE("Packs: their exponential is that of each lane", "[pack]") {
  for (double x = -9.0; x < 1.0; x += 1e-3) {
    const Pack several = Pack(x) + Pack(2.5e-4) * counting;
    for (int lane = 0; lane < static_cast<int>(pack_width); ++lane) {
      const double one = exponential(double(several[lane]));
      CHECK(std::abs(exponential(several)[lane] - one) <= 4e-16 * one);
    }
  }
  CHECK(exponential(Pack(0.0))[0] == 1.0);
}

TEST_CASE("Packs: their logarithm is that of each lane", "[pack]") {
  for (double x = 1e-300; x < 1e300; x *= 1.37) {
    const WidePack several([&](int lane) { return x * (1.0 + 0.1 * lane); });
    for (int lane = 0; lane < static_cast<int>(wide_pack_width); ++lane) {
      const double one = logarithm(double(several[lane]));
      CHECK(std::abs(logarithm(several)[lane] - one) <= 4e-16 * (1.0 + std::abs(one)));
    }
  }
  CHECK(logarithm(WidePack(1.0))[0] == 0.0);
}

TEST_CASE("Packs: their powers are those of each lane", "[pack]") {
  for (const double n : {0.01, 0.41, 1.0, 1.8, 9.9})
    for (double x = 1e-30; x < 1e3; x *= 1.37) {
      const WidePack several([&](int lane) { return x * (1.0 + 0.1 * lane); });
      for (int lane = 0; lane < static_cast<int>(wide_pack_width); ++lane) {
        const double one = power(double(several[lane]), n);
        CHECK(std::abs(power(several, n)[lane] - one) <= 4e-16 * (1.0 + n * std::abs(std::log(one) / n)) * one);
      }
    }
  CHECK(power(WidePack(0.0), 0.41)[0] == 0.0);
  CHECK(power(WidePack(0.0), 0.0)[0] == power(0.0, 0.0));
  CHECK(power(WidePack(1.0), 0.41)[0] == 1.0);
}

TEST_CASE("Packs: the sum adds all lanes in one order", "[pack]") {
  CHECK(sum(counting) == 10.0);
  const Pack wide([](int lane) { return lane == 0 ? 1e16 : lane == 2 ? -1e16 : 1.0; });
  CHECK(sum(wide) == 2.0);  // (0 + 2) + (1 + 3): in another order the ones would be lost
}

TEST_CASE("Packs: the largest lane is found wherever it is", "[pack]") {
  for (int place = 0; place < static_cast<int>(pack_width); ++place)
    CHECK(largest(Pack([&](int lane) { return lane == place ? 7.0 : -7.0; })) == 7.0);
}

TEST_CASE("Pack: rows gathered from four places are turned, number by number", "[pack]") {
  double memory[4][8];
  const double* place[pack_width];
  for (int lane = 0; lane < 4; ++lane) {
    for (int k = 0; k < 8; ++k) memory[lane][k] = 10.0 * lane + k;
    place[lane] = memory[3 - lane];
  }
  Pack turned[8];
  gather<2>(place, turned);
  for (int k = 0; k < 8; ++k)
    for (std::size_t lane = 0; lane < pack_width; ++lane)
      CHECK(turned[k][lane] == 10.0 * (3.0 - static_cast<double>(lane)) + k);
}
