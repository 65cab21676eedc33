#pragma once
// Who looks at a run: frames that are mirrored or turned by right angles, and how far two fields differ.

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "core/tensor.hpp"

namespace tektite::test {

/// Axis k of the new frame is axis[k] of the old one, times sign[k].
struct Turn {
  int axis[3];
  double sign[3];
};

template <int D>
Vector<double, D> turned(const Turn& turn, const Vector<double, D>& x) {
  Vector<double, D> y;
  for (int k = 0; k < D; ++k) y[k] = turn.sign[k] * x[turn.axis[k]];
  return y;
}

template <int D>
Symmetric<double, D> turned(const Turn& turn, const Symmetric<double, D>& s) {
  auto t = s;
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j) t(i, j) = turn.sign[i] * turn.sign[j] * s(turn.axis[i], turn.axis[j]);
  return t;
}

/// Largest difference of two fields in any component, over `scale`.
inline double difference(const std::vector<double>& a, const std::vector<double>& b, double scale) {
  REQUIRE(a.size() == b.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = std::abs(a[i] - b[i]);
    largest = d > largest || std::isnan(d) ? d : largest;
  }
  return largest / scale;
}

template <int D>
std::vector<double> turned_vectors(const Turn& turn, std::vector<double> values) {
  auto* v = reinterpret_cast<Vector<double, D>*>(values.data());
  for (std::size_t i = 0; i < values.size() / D; ++i) v[i] = turned<D>(turn, v[i]);
  return values;
}

template <int D>
std::vector<double> turned_stress(const Turn& turn, std::vector<double> values) {
  auto* s = reinterpret_cast<Symmetric<double, D>*>(values.data());
  for (std::size_t i = 0; i < values.size() / Symmetric<double, D>::size; ++i) s[i] = turned<D>(turn, s[i]);
  return values;
}

inline constexpr Turn mirror_x{{0, 1, 2}, {-1.0, 1.0, 1.0}};
inline constexpr Turn quarter_about_z{{1, 0, 2}, {-1.0, 1.0, 1.0}};
inline constexpr Turn cyclic{{1, 2, 0}, {1.0, 1.0, 1.0}};
inline constexpr Turn quarter_about_x{{0, 2, 1}, {1.0, -1.0, 1.0}};

}  // namespace tektite::test
