#pragma once

#include <numbers>
#include <string_view>

#include "core/pack.hpp"

namespace tektite {

/// The cubic B-spline of Monaghan and Lattanzio (1985), support 2h.
struct CubicSpline {
  static constexpr std::string_view name = "cubic-spline";
  static constexpr double support = 2.0;

  template <int D>
  static constexpr double normalisation() {
    return D == 1 ? 2.0 / 3.0 : D == 2 ? 10.0 / (7.0 * std::numbers::pi) : 1.0 / std::numbers::pi;
  }

  /// q < support is the caller's concern, here and below.
  template <class T>
  static T shape(const T& q) {
    const T rest = T(2.0) - q;
    return select(q < T(1.0), T(1.0) + q * q * (T(0.75) * q - T(1.5)), T(0.25) * rest * rest * rest);
  }

  /// w'(q)/q; divided by no q of the other branch, which may be zero
  template <class T>
  static T slope_over_q(const T& q) {
    const T rest = T(2.0) - q;
    return select(q < T(1.0), T(2.25) * q - T(3.0), T(-0.75) * rest * rest / larger(q, T(1.0)));
  }

  /// w'(q), without a division
  template <class T>
  static T slope(const T& q) {
    const T rest = T(2.0) - q;
    return select(q < T(1.0), q * (T(2.25) * q - T(3.0)), T(-0.75) * rest * rest);
  }
};

}  // namespace tektite
