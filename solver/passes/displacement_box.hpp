#pragma once

#include <algorithm>
#include <limits>

#include "core/tensor.hpp"

namespace tektite {

/// The box of all displacements since the last search of neighbours, at the time `ahead` from now.
template <int D>
struct DisplacementBox {
  struct Box {
    Vector<double, D> lower;
    Vector<double, D> upper;
    Box() {
      for (int k = 0; k < D; ++k) {
        lower[k] = std::numeric_limits<double>::infinity();
        upper[k] = -lower[k];
      }
    }
    bool empty() const { return lower[0] > upper[0]; }
  };

  const Vector<double, D>* position;
  const Vector<double, D>* velocity;
  const Vector<double, D>* acceleration;
  const Vector<double, D>* search_position;
  double ahead;

  void operator()(Box& box, std::size_t i) const {
    for (int k = 0; k < D; ++k) {
      const double d =
          position[i][k] + ahead * (velocity[i][k] + 0.5 * ahead * acceleration[i][k]) - search_position[i][k];
      box.lower[k] = std::min(box.lower[k], d);
      box.upper[k] = std::max(box.upper[k], d);
    }
  }
  static void join(Box& whole, const Box& part) {
    for (int k = 0; k < D; ++k) {
      whole.lower[k] = std::min(whole.lower[k], part.lower[k]);
      whole.upper[k] = std::max(whole.upper[k], part.upper[k]);
    }
  }
};

}  // namespace tektite
