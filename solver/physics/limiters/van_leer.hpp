#pragma once

#include <array>
#include <limits>

#include "physics/limiters/agreeing.hpp"
#include "physics/model.hpp"

namespace tektite {

/// φ(r) = (r + |r|)/(1 + |r|): the time-split Godunov paper, eq. 27.
struct VanLeerLimiter {
  static constexpr std::string_view name = "van-leer";
  static std::array<Parameter<VanLeerLimiter>, 0> parameters() { return {}; }

  template <class T>
  T operator()(const T& a, const T& b) const {
    const T p = magnitude(a), q = magnitude(b);
    return agreeing(a, b, T(2.0) * p * (q / larger(p + q, T(std::numeric_limits<double>::min()))));
  }
};

}  // namespace tektite
