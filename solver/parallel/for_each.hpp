#pragma once
// The loops over particles. This room alone knows threads; the bodies are small functors with views by value. A body
// writes only to its own particle, so the answer is the same for any number of threads.

#include <algorithm>
#include <cstddef>

#include "core/particles.hpp"

namespace tektite {

/// A run of particles that one thread takes at a time. Flattened: a body is one loop, whatever it calls.
template <class Body>
[[gnu::flatten]] void run_through(std::size_t begin, std::size_t end, const Body& body) {
  for (std::size_t i = begin; i < end; ++i) body(i);
}

/// body(i) for every i of the range.
template <class Body>
void for_each(const Range& range, const Body& body) {
  constexpr std::size_t run = 1024;
#pragma omp parallel for schedule(static)
  for (std::size_t begin = range.begin; begin < range.end; begin += run)
    run_through(begin, std::min(begin + run, range.end), body);
}

}  // namespace tektite
