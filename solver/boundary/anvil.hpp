#pragma once

#include <optional>

#include "core/scene.hpp"
#include "core/tensor.hpp"

namespace tektite {

/// A rigid smooth wall at rest (Batra and Zhang 2008, section 4.2): what has come to it does not pass it, slides along
/// it, and leaves it where the normal stress turns tensile.
template <int D>
class Anvil {
 public:
  explicit Anvil(const std::optional<SymmetryPlane>& plane) : plane_(plane) {}

  int axis() const { return plane_ ? plane_->axis : -1; }

  /// Whether a particle here, with this normal stress in Pa, is held by it.
  bool holds(const Vector<double, D>& x, double normal_stress) const {
    return plane_ && touches(x) && normal_stress <= 0.0;
  }
  bool touches(const Vector<double, D>& x) const {
    return plane_ && plane_->side * (x[plane_->axis] - plane_->at) <= 0.0;
  }

  /// Brings a place back to the wall where it has passed it.
  void keep_out(Vector<double, D>& x) const {
    if (touches(x)) x[plane_->axis] = plane_->at;
  }

 private:
  std::optional<SymmetryPlane> plane_;
};

}  // namespace tektite
