#pragma once

#include <array>

#include "physics/limiters/agreeing.hpp"
#include "physics/model.hpp"

namespace tektite {

/// φ(r) = max(0, min(2 r, (1 + r)/2, 2)): the time-split Godunov paper, eq. 27.
struct MonotonizedCentralLimiter {
  static constexpr std::string_view name = "monotonized-central";
  static std::array<Parameter<MonotonizedCentralLimiter>, 0> parameters() { return {}; }

  template <class T>
  T operator()(const T& a, const T& b) const {
    const T p = magnitude(a), q = magnitude(b);
    return agreeing(a, b, smaller(T(2.0) * smaller(p, q), T(0.5) * (p + q)));
  }
};

}  // namespace tektite
