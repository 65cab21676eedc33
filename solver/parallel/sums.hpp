#pragma once
// Sums over particles that are the same to the last bit in whatever order and on however many ranks: what each term has
// above a common bit is summed without rounding, and so is what is left of it above a lower one (Demmel and Nguyen
// 2013, "Fast Reproducible Floating-Point Summation", with two parts; the parts of Rump, Ogita and Oishi 2008,
// ExtractVector). For a million particles the error is 2^-44 of the largest term.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/pack.hpp"
#include "parallel/reduce.hpp"

namespace tektite {

/// Adding a number to 1.5 · 2^e and taking it away again rounds it to a multiple of 2^(e - 52). One such number for the
/// upper part of each term and one for the lower; zero where all terms are.
template <std::size_t N>
struct Scales {
  std::array<double, N> high{}, low{};

  /// So large that the sum of `count` multiples is one itself, and below 2^e, where no term is beyond `most`.
  static Scales of(const std::array<double, N>& most, std::size_t count) {
    Scales scales;
    const int room = std::ilogb(static_cast<double>(count)) + 2;
    for (std::size_t k = 0; k < N; ++k) {
      if (most[k] == 0.0) continue;
      if (!std::isfinite(most[k])) {
        scales.high[k] = scales.low[k] = most[k];
        continue;
      }
      const int exponent = std::ilogb(most[k]) + 1 + room;
      scales.high[k] = std::ldexp(1.5, exponent);
      scales.low[k] = std::ldexp(1.5, exponent - 53 + room);
    }
    return scales;
  }
  bool operator==(const Scales&) const = default;
};

/// What comes together of the terms: the sums of both parts, and the largest absolute value.
template <std::size_t N>
struct Summed {
  std::array<double, N> high{}, low{}, most{};

  void join(const Summed& part) {
    for (std::size_t k = 0; k < N; ++k) {
      high[k] += part.high[k];
      low[k] += part.low[k];
      most[k] = std::max(most[k], part.most[k]);
    }
  }
};

/// Terms of some particles, written down number by number and split side by side: a sum without rounding may be taken
/// in any order.
template <std::size_t N, class Terms>
struct SumOfSome {
  static constexpr std::size_t together = 128;  // whose terms fit into the nearest cache; a whole number of packs

  const Terms& terms;
  const Scales<N>& scales;
  Owned counts;
  Range range;

  /// Those of the n-th `together` of the range.
  TEKTITE_UNFUSED void operator()(Summed<N>& so_far, std::size_t n) const {
    const std::size_t begin = range.begin + n * together, count = std::min(together, range.end - begin);
    double term[N][together];
    for (std::size_t i = 0; i < count; ++i) {
      const auto numbers = counts(begin + i) ? terms(begin + i) : std::array<double, N>{};
      for (std::size_t k = 0; k < N; ++k) term[k][i] = numbers[k];
    }
    for (std::size_t k = 0; k < N; ++k) {
      std::fill(term[k] + count, term[k] + together, 0.0);
      add(so_far, k, term[k]);
    }
  }

 private:
  void add(Summed<N>& so_far, std::size_t k, const double* term) const {
    const WidePack high_scale = scales.high[k], low_scale = scales.low[k];
    WidePack high = 0.0, low = 0.0, most = 0.0;
    for (std::size_t i = 0; i < together; i += wide_pack_width) {
      const WidePack each(term + i, std::experimental::element_aligned);
      const WidePack upper = (high_scale + each) - high_scale;
      high += upper;
      low += (low_scale + (each - upper)) - low_scale;
      const WidePack size = abs(each);
      most = select(size > most, size, most);  // a number that is none is left out
    }
    for (std::size_t lane = 0; lane < wide_pack_width; ++lane) {
      so_far.high[k] += high[lane];
      so_far.low[k] += low[lane];
      so_far.most[k] = std::max<double>(so_far.most[k], most[lane]);
    }
  }
};

/// Σ terms(i), arrays of N numbers, over the particles of a range; of those that are distributed over the ranks, each
/// once. Sweeps until the scales are those that the largest terms want, with which it leaves `scales`: right ones spare
/// a sweep, and change no bit of the sum.
template <std::size_t N, class Terms>
std::array<double, N> sum_over(const Particles& particles, const Range& range, const Terms& terms, Scales<N>& scales) {
  using Some = SumOfSome<N, Terms>;
  const auto join = [](Summed<N>& whole, const Summed<N>& part) { whole.join(part); };
  const std::size_t count = count_of_all(particles);
  for (;;) {
    const Some some{terms, scales, Owned(particles), range};
    const auto sums = over_ranks(
        particles, reduce((range.size() + Some::together - 1) / Some::together, Summed<N>{}, some, join), join);
    const auto wanted = Scales<N>::of(sums.most, count);
    if (wanted == scales) {
      std::array<double, N> sum;
      for (std::size_t k = 0; k < N; ++k) sum[k] = sums.high[k] + sums.low[k];
      return sum;
    }
    scales = wanted;
  }
}

/// The same where nothing is known of the terms.
template <std::size_t N, class Terms>
std::array<double, N> sum_over(const Particles& particles, const Range& range, const Terms& terms) {
  Scales<N> scales;
  return sum_over<N>(particles, range, terms, scales);
}

/// The same over all particles.
template <std::size_t N, class Terms>
std::array<double, N> sum_over(const Particles& particles, const Terms& terms) {
  return sum_over<N>(particles, {0, particles.count()}, terms);
}

/// Over all particles, again and again: from one time to the next the largest terms seldom want other scales.
template <std::size_t N>
class RepeatedSum {
 public:
  template <class Terms>
  std::array<double, N> operator()(const Particles& particles, const Terms& terms) {
    return sum_over<N>(particles, {0, particles.count()}, terms, scales_);
  }

 private:
  Scales<N> scales_;
};

}  // namespace tektite
