#pragma once

#include <numbers>
#include <string_view>

#include "core/pack.hpp"
#include "physics/elementary.hpp"

namespace tektite {

/// The Gaussian cut at 2h and lowered to be continuous there: Batra and Zhang (2008), eq. 2.8, whose constant for two
/// dimensions is 1 / (π (1 - 5 e^-4)); the others follow from the same integral.
struct TruncatedGaussian {
  static constexpr std::string_view name = "truncated-gaussian";
  static constexpr double support = 2.0;
  static constexpr double cut = 0.018315638888734179;        // e^-4
  static constexpr double erf_of_two = 0.99532226501895271;  // erf(2)

  template <int D>
  static constexpr double normalisation() {
    constexpr double root_pi = 1.0 / std::numbers::inv_sqrtpi;
    constexpr double pi = std::numbers::pi;
    return D == 1   ? 1.0 / (root_pi * erf_of_two - 4.0 * cut)
           : D == 2 ? 1.0 / (pi * (1.0 - 5.0 * cut))
                    : 1.0 / (pi * (root_pi * erf_of_two - 4.0 * cut - 32.0 / 3.0 * cut));
  }

  template <class T>
  static T shape(const T& q) {
    return exponential(-q * q) - T(cut);
  }

  /// w'(q)/q = -2 e^(-q²)
  template <class T>
  static T slope_over_q(const T& q) {
    return T(-2.0) * exponential(-q * q);
  }

  /// w'(q)
  template <class T>
  static T slope(const T& q) {
    return q * slope_over_q(q);
  }
};

}  // namespace tektite
