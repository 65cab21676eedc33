#pragma once
// e^x of several numbers at once. The exp of std::experimental::simd calls the library once a lane, which took a third
// of a step of msph and of a step with the truncated Gaussian (tests/performance/README.md).

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/pack.hpp"

namespace tektite {

inline double exponential(double x) { return std::exp(x); }

/// e^x for |x| < 700, within 3e-16 of it: x = k ln 2 + r with |r| ≤ ½ ln 2, ln 2 in two parts so that r is exact to
/// round-off, and the Taylor series of e^r to r¹² (its rest is below 2e-16).
template <class T>
T exponential(const T& x) {
  typedef std::int64_t Bits __attribute__((vector_size(sizeof(T))));
  constexpr double shift = 0x1.8p52;  // adding it rounds to a whole number and leaves that in the lowest bits
  const T shifted = x * T(1.4426950408889634) + T(shift);
  const T k = shifted - T(shift);
  const T r = (x - k * T(0x1.62e42fefa0000p-1)) - k * T(0x1.cf79abc9e3b3ap-40);
  T e = 1.0 / 479001600.0;
  for (const double factorial :
       {39916800.0, 3628800.0, 362880.0, 40320.0, 5040.0, 720.0, 120.0, 24.0, 6.0, 2.0, 1.0, 1.0})
    e = e * r + T(1.0 / factorial);
  constexpr std::int64_t bias = 1023, mantissa = 52;
  const Bits exponent = (std::bit_cast<Bits>(shifted) + bias) << mantissa;
  return e * std::bit_cast<T>(exponent);
}

}  // namespace tektite
