#pragma once
// Fields of several particles side by side, one in each lane, for point passes that are worth it: those with powers,
// roots and divisions, which cost as much for a pack as for one number.

#include <algorithm>
#include <cstddef>

#include "core/pack.hpp"
#include "core/tensor.hpp"

namespace tektite {

/// At most wide_pack_width particles from `first` on. Lanes behind `count` hold the last particle once more.
struct SideBySide {
  std::size_t first, count;

  std::size_t in_lane(std::size_t lane) const { return first + std::min(lane, count - 1); }
};

/// number(i) of each.
template <class Number>
[[gnu::always_inline]] inline WidePack each(const SideBySide& particles, const Number& number) {
  return WidePack([&](auto lane) { return number(particles.in_lane(lane)); });
}

[[gnu::always_inline]] inline WidePack read(const double* field, const SideBySide& particles) {
  return each(particles, [&](std::size_t i) { return field[i]; });
}
template <int D>
[[gnu::always_inline]] inline auto read(const Tensor<double, D>* field, const SideBySide& particles) {
  Tensor<WidePack, D> t;
  for (int k = 0; k < D * D; ++k) t.c[k] = each(particles, [&](std::size_t i) { return field[i].c[k]; });
  return t;
}
template <int D>
[[gnu::always_inline]] inline auto read(const Symmetric<double, D>* field, const SideBySide& particles) {
  Symmetric<WidePack, D> s;
  for (int k = 0; k < s.size; ++k) s.c[k] = each(particles, [&](std::size_t i) { return field[i].c[k]; });
  return s;
}

[[gnu::always_inline]] inline void write(double* field, const SideBySide& particles, const WidePack& numbers) {
  for (std::size_t lane = 0; lane < particles.count; ++lane) field[particles.first + lane] = numbers[lane];
}
template <int D>
[[gnu::always_inline]] inline void write(Symmetric<double, D>* field, const SideBySide& particles,
                                         const Symmetric<WidePack, D>& s) {
  for (int k = 0; k < s.size; ++k)
    for (std::size_t lane = 0; lane < particles.count; ++lane) field[particles.first + lane].c[k] = s.c[k][lane];
}

}  // namespace tektite
