#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/scene.hpp"
#include "core/tensor.hpp"

namespace tektite {

/// The box about some vectors, such as the displacements or the velocities of particles.
template <int D>
struct VectorBox {
  Vector<double, D> lower;
  Vector<double, D> upper;

  VectorBox() {
    for (int k = 0; k < D; ++k) {
      lower[k] = std::numeric_limits<double>::infinity();
      upper[k] = -lower[k];
    }
  }
  bool empty() const { return lower[0] > upper[0]; }
  void take(const Vector<double, D>& v) {
    for (int k = 0; k < D; ++k) {
      lower[k] = std::min(lower[k], v[k]);
      upper[k] = std::max(upper[k], v[k]);
    }
  }
  static void join(VectorBox& whole, const VectorBox& part) {
    for (int k = 0; k < D; ++k) {
      whole.lower[k] = std::min(whole.lower[k], part.lower[k]);
      whole.upper[k] = std::max(whole.upper[k], part.upper[k]);
    }
  }
  /// The largest difference of two of the vectors, or of one and the image of another behind one of the planes.
  double diagonal(std::span<const SymmetryPlane> planes) const {
    double square = 0.0;
    for (int k = 0; k < D; ++k) {
      double width = upper[k] - lower[k];
      for (const auto& plane : planes)
        if (plane.axis == k) width = 2.0 * std::max(std::abs(upper[k]), std::abs(lower[k]));
      square += width * width;
    }
    return std::sqrt(square);
  }
};

}  // namespace tektite
