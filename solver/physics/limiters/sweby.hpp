#pragma once

#include <array>

#include "physics/limiters/agreeing.hpp"
#include "physics/model.hpp"

namespace tektite {

/// φ(r) = max(0, min(β r, 1), min(r, β)), 1 ≤ β ≤ 2: the time-split Godunov paper, eq. 27. β = 1 is minmod, β = 2 Roe's
/// superbee, which that paper uses.
struct SwebyLimiter {
  static constexpr std::string_view name = "sweby";
  double beta = 0.0;

  static auto parameters() {
    return std::array{Parameter<SwebyLimiter>{
        "beta", &SwebyLimiter::beta, dimension::none, {1.0, 2.0}, "1 for minmod to 2 for superbee", 2.0}};
  }

  template <class T>
  T operator()(const T& a, const T& b) const {
    const T p = magnitude(a), q = magnitude(b);
    return agreeing(a, b, larger(smaller(T(beta) * p, q), smaller(p, T(beta) * q)));
  }
};

}  // namespace tektite
