#pragma once

#include <array>

#include "core/pack.hpp"
#include "physics/model.hpp"

namespace tektite {

/// φ(r) = (r + |r|)/(1 + |r|), so 2 a b/(a + b) where both have one sign: the time-split Godunov paper, eq. 27.
struct VanLeerLimiter {
  static constexpr std::string_view name = "van-leer";
  static std::array<Parameter<VanLeerLimiter>, 0> parameters() { return {}; }

  template <class T>
  T operator()(const T& a, const T& b) const {
    const auto agree = a * b > T(0.0);
    return select(agree, T(2.0) * a * (b / select(agree, a + b, T(1.0))), T(0.0));
  }
};

}  // namespace tektite
