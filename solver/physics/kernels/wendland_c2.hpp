#pragma once

#include <numbers>
#include <string_view>

#include "core/pack.hpp"

namespace tektite {

/// Wendland's C2 function (1995) with support 2h: in two and three dimensions (1 - q/2)^4 (2q + 1), in one (1 - q/2)^3
/// (1.5 q + 1). One shape serves all: the 2-D and 3-D one is positive definite in one dimension too.
struct WendlandC2 {
  static constexpr std::string_view name = "wendland-c2";
  static constexpr double support = 2.0;

  template <int D>
  static constexpr double normalisation() {
    return D == 1 ? 3.0 / 4.0 : D == 2 ? 7.0 / (4.0 * std::numbers::pi) : 21.0 / (16.0 * std::numbers::pi);
  }

  template <class T>
  static T shape(const T& q) {
    const T rest = T(1.0) - T(0.5) * q;
    const T square = rest * rest;
    return square * square * (T(2.0) * q + T(1.0));
  }

  /// w'(q)/q = -5 (1 - q/2)^3
  template <class T>
  static T slope_over_q(const T& q) {
    const T rest = T(1.0) - T(0.5) * q;
    return T(-5.0) * rest * rest * rest;
  }

  /// w'(q)
  template <class T>
  static T slope(const T& q) {
    return q * slope_over_q(q);
  }
};

}  // namespace tektite
