#pragma once

#include "core/pack.hpp"

namespace tektite {

// Inlined whatever the compiler thinks of it: each call in a sweep over pairs would write all sums to memory.

/// |a|
template <class T>
[[gnu::always_inline]] inline T magnitude(const T& a) {
  return larger(a, -a);
}

/// `size` with the sign that both slopes have; zero where they have none in common.
template <class T>
[[gnu::always_inline]] inline T agreeing(const T& a, const T& b, const T& size) {
  return select(a * b > T(0.0), select(a > T(0.0), size, -size), T(0.0));
}

}  // namespace tektite
