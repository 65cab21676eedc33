#pragma once
// e^x, ln x and powers of several numbers at once. Those of std::experimental::simd call the library once a lane, which
// took a third of a step of msph and of a step with the truncated Gaussian, and half of what plastic flow by Johnson
// and Cook costs (tests/performance/README.md).

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/pack.hpp"

namespace tektite {

inline double exponential(double x) { return std::exp(x); }
inline double logarithm(double x) { return std::log(x); }
/// x^n for x ≥ 0 and n ≥ 0; 0^0 is 1.
inline double power(double x, double n) { return std::pow(x, n); }

/// As many whole numbers of 64 bits as a T has lanes.
template <class T>
struct BitsOf {
  typedef std::int64_t Type __attribute__((vector_size(sizeof(T))));
};

/// Adding it rounds to a whole number and leaves that in the lowest bits.
inline constexpr double rounding_shift = 0x1.8p52;
/// ln 2 in two parts, so that a multiple of the first is exact.
inline constexpr double ln2_high = 0x1.62e42fefa0000p-1, ln2_low = 0x1.cf79abc9e3b3ap-40;

/// e^x for |x| < 700, within 3e-16 of it: x = k ln 2 + r with |r| ≤ ½ ln 2, and the Taylor series of e^r to r¹² (its
/// rest is below 2e-16).
template <class T>
T exponential(const T& x) {
  using Bits = typename BitsOf<T>::Type;
  const T shifted = x * T(1.4426950408889634) + T(rounding_shift);
  const T k = shifted - T(rounding_shift);
  const T r = (x - k * T(ln2_high)) - k * T(ln2_low);
  T e = 1.0 / 479001600.0;
  for (const double factorial :
       {39916800.0, 3628800.0, 362880.0, 40320.0, 5040.0, 720.0, 120.0, 24.0, 6.0, 2.0, 1.0, 1.0})
    e = e * r + T(1.0 / factorial);
  constexpr std::int64_t bias = 1023, mantissa = 52;
  const Bits exponent = (std::bit_cast<Bits>(shifted) + bias) << mantissa;
  return e * std::bit_cast<T>(exponent);
}

/// ln x for normal x > 0, within 4e-16 of it and of its size: x = m 2^k with √½ ≤ m < √2, and
/// ln m = 2 artanh s, s = (m - 1)/(m + 1), |s| < 0.172, by its series to s²¹ (its rest is below 1e-18).
template <class T>
T logarithm(const T& x) {
  using Bits = typename BitsOf<T>::Type;
  constexpr std::int64_t mantissa = 52, root_half = 0x3fe6a09e667f3bcd;  // the bits of √½
  const Bits bits = std::bit_cast<Bits>(x);
  const Bits exponent = (bits - root_half) >> mantissa;
  const T m = std::bit_cast<T>(bits - (exponent << mantissa));
  const T k = std::bit_cast<T>(exponent + std::bit_cast<std::int64_t>(rounding_shift)) - T(rounding_shift);
  const T s = (m - T(1.0)) / (m + T(1.0));
  const T square = s * s;
  T series = 1.0 / 21.0;
  for (const double odd : {19.0, 17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0}) series = series * square + T(1.0 / odd);
  const T twice = T(2.0) * s;
  return k * T(ln2_high) + (twice + (twice * square * series + k * T(ln2_low)));
}

/// x^n for x ≥ 0 and n ≥ 0, within 1 + |n ln x| times 4e-16 of it; below 1e-300 as for zero, of which 0^0 is 1.
template <class T>
T power(const T& x, double n) {
  constexpr double least = 1e-300, lowest = -690.0;
  const T result = exponential(larger(T(n) * logarithm(larger(x, T(least))), T(lowest)));
  return select(x > T(least), result, T(n == 0.0 ? 1.0 : 0.0));
}

}  // namespace tektite
