#pragma once
// What this machine can do at most on one core: the vector units, by a loop of multiplications and additions that
// depend on nothing but themselves; and the memory, by a stream through arrays that fit no cache.

#include <benchmark/benchmark.h>

#include <array>
#include <vector>

#include "core/pack.hpp"

namespace tektite {

/// Floating-point operations per second, a fused multiplication and addition being two.
inline void multiply_and_add(benchmark::State& state) {
  constexpr std::size_t chains = 16;  // more than two units times their latency of four
  constexpr int rounds = 1000;
  std::array<WidePack, chains> sums;
  for (std::size_t k = 0; k < chains; ++k) sums[k] = 1e-3 * static_cast<double>(k);
  WidePack factor = 0.999, term = 1e-3;
  benchmark::DoNotOptimize(factor);
  benchmark::DoNotOptimize(term);
  for (auto _ : state) {
    for (int round = 0; round < rounds; ++round)
      for (auto& sum : sums) sum = sum * factor + term;
    benchmark::DoNotOptimize(sums);
  }
  const double operations = 2.0 * rounds * chains * wide_pack_width;
  state.counters["operations_per_second"] =
      benchmark::Counter(operations * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

/// Bytes per second of a = b + 3 c, two arrays read and one written.
inline void stream(benchmark::State& state) {
  constexpr std::size_t size = 1 << 24;
  std::vector<double> a(size), b(size, 1.0), c(size, 2.0);
  for (auto _ : state) {
    for (std::size_t k = 0; k < size; ++k) a[k] = b[k] + 3.0 * c[k];
    benchmark::ClobberMemory();
  }
  state.counters["bytes_per_second"] = benchmark::Counter(
      3.0 * size * sizeof(double) * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

}  // namespace tektite
