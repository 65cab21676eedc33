#pragma once

#include <cstdint>

#include "core/tensor.hpp"

namespace tektite {

/// Clamped particles do not move.
template <int D>
struct HoldClamped {
  const std::int64_t* clamped;
  Vector<double, D>* rate;  ///< of the place or of the velocity

  void operator()(std::size_t i) const {
    if (clamped[i] != 0) rate[i] = Vector<double, D>::zero();
  }
};

}  // namespace tektite
