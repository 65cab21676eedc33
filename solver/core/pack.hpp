#pragma once
// Several neighbours at once. Formulas are templates over their number type and run on one double or on a Pack of
// them alike. The width is fixed, so that sums have the same order, and the same bits, on every machine that fuses
// multiplications and additions alike. Four doubles: wider packs leave more lanes empty at the end of short lists.

#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <experimental/simd>

namespace tektite {

inline constexpr std::size_t pack_width = 4;
using Pack = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, pack_width>>;

/// Several particles at once, each in a lane of its own: no sum runs over the lanes, so the width changes no bit.
#ifdef __AVX512F__
inline constexpr std::size_t wide_pack_width = 8;
#else
inline constexpr std::size_t wide_pack_width = pack_width;
#endif
using WidePack = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, wide_pack_width>>;

// Always inlined: a call inside a loop over pairs would put every register into memory.
/// Lane by lane, `yes` where the condition holds. Clang takes the wrong lanes in the masked assignment of libstdc++ 12.
template <class P>
[[gnu::always_inline]] inline P chosen(const typename P::mask_type& condition, const P& yes, P no) {
#ifdef __clang__
  return P([&](auto lane) { return condition[lane] ? yes[lane] : no[lane]; });
#else
  where(condition, no) = yes;
  return no;
#endif
}
[[gnu::always_inline]] inline double select(bool condition, double yes, double no) { return condition ? yes : no; }
[[gnu::always_inline]] inline Pack select(const Pack::mask_type& condition, const Pack& yes, const Pack& no) {
  return chosen(condition, yes, no);
}
[[gnu::always_inline]] inline double larger(double a, double b) { return a > b ? a : b; }
[[gnu::always_inline]] inline Pack larger(const Pack& a, const Pack& b) { return std::experimental::max(a, b); }
[[gnu::always_inline]] inline double smaller(double a, double b) { return a < b ? a : b; }
[[gnu::always_inline]] inline Pack smaller(const Pack& a, const Pack& b) { return std::experimental::min(a, b); }

// The same where a WidePack is no Pack.
template <class T>
concept OnlyWide = std::same_as<T, WidePack> && !std::same_as<T, Pack>;
template <OnlyWide T>
[[gnu::always_inline]] inline T select(const typename T::mask_type& condition, const T& yes, const T& no) {
  return chosen(condition, yes, no);
}
template <OnlyWide T>
[[gnu::always_inline]] inline T larger(const T& a, const T& b) {
  return std::experimental::max(a, b);
}
template <OnlyWide T>
[[gnu::always_inline]] inline T smaller(const T& a, const T& b) {
  return std::experimental::min(a, b);
}

/// Reads `rows` times four numbers from each of four places and turns them: out[k] holds the k-th number of each place.
/// Whole rows are loaded and turned in registers, which takes half the instructions of reading number by number.
template <std::size_t rows>
void gather(const double* const (&place)[pack_width], Pack (&out)[rows * pack_width]) {
  typedef double Row __attribute__((vector_size(pack_width * sizeof(double)), aligned(alignof(double)), may_alias));
  typedef double Turned __attribute__((vector_size(pack_width * sizeof(double))));
  for (std::size_t row = 0; row < rows; ++row) {
    Turned lane[pack_width];
    for (std::size_t k = 0; k < pack_width; ++k) lane[k] = *reinterpret_cast<const Row*>(place[k] + row * pack_width);
    const Turned a = __builtin_shufflevector(lane[0], lane[1], 0, 4, 2, 6);
    const Turned b = __builtin_shufflevector(lane[0], lane[1], 1, 5, 3, 7);
    const Turned c = __builtin_shufflevector(lane[2], lane[3], 0, 4, 2, 6);
    const Turned d = __builtin_shufflevector(lane[2], lane[3], 1, 5, 3, 7);
    out[row * pack_width + 0] = std::bit_cast<Pack>(__builtin_shufflevector(a, c, 0, 1, 4, 5));
    out[row * pack_width + 1] = std::bit_cast<Pack>(__builtin_shufflevector(b, d, 0, 1, 4, 5));
    out[row * pack_width + 2] = std::bit_cast<Pack>(__builtin_shufflevector(a, c, 2, 3, 6, 7));
    out[row * pack_width + 3] = std::bit_cast<Pack>(__builtin_shufflevector(b, d, 2, 3, 6, 7));
  }
}

inline double sum(const Pack& a) { return (a[0] + a[2]) + (a[1] + a[3]); }
inline double largest(const Pack& a) { return larger(larger(a[0], a[1]), larger(a[2], a[3])); }

}  // namespace tektite
