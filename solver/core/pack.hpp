#pragma once
// Several neighbours at once. Formulas are templates over their number type and run on one double or on a Pack of
// them alike. The width is fixed, so that sums have the same order, and the same bits, on every machine that fuses
// multiplications and additions alike. Four doubles: wider packs leave more lanes empty at the end of short lists.

#include <cmath>
#include <cstddef>
#include <experimental/simd>

namespace tektite {

inline constexpr std::size_t pack_width = 4;
using Pack = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, pack_width>>;

inline double select(bool condition, double yes, double no) { return condition ? yes : no; }
inline Pack select(const Pack::mask_type& condition, const Pack& yes, Pack no) {
  where(condition, no) = yes;
  return no;
}
inline double larger(double a, double b) { return a > b ? a : b; }
inline Pack larger(const Pack& a, const Pack& b) { return std::experimental::max(a, b); }
inline double smaller(double a, double b) { return a < b ? a : b; }
inline Pack smaller(const Pack& a, const Pack& b) { return std::experimental::min(a, b); }

inline double sum(const Pack& a) { return (a[0] + a[2]) + (a[1] + a[3]); }
inline double largest(const Pack& a) { return larger(larger(a[0], a[1]), larger(a[2], a[3])); }

}  // namespace tektite
