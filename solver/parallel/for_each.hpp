#pragma once
// The loops over particles. This room alone knows threads; the bodies are small functors with views by value. A body
// writes only to its own particle, so the answer is the same for any number of threads.

#include <cstddef>

#include "core/particles.hpp"

namespace tektite {

/// body(i) for every i of the range.
template <class Body>
void for_each(const Range& range, const Body& body) {
#pragma omp parallel for schedule(static)
  for (std::size_t i = range.begin; i < range.end; ++i) body(i);
}

}  // namespace tektite
