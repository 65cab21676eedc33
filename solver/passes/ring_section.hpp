#pragma once
// How far from the axis the section of a ring lies.

#include <cmath>
#include <numbers>

#include "core/tensor.hpp"

namespace tektite {

/// The section A of a ring about its radius r is a square of half-width w = √A/2. What of it would lie beyond the axis,
/// where r < w, is folded back: points at r' stand for |r'|. Its radius is then the mean of |r'|, and its hoop rate
/// that of the odd field v_r + (r' - r) ∂v_r/∂r over it:
///   r̄ = (r² + w²)/2w,  D_θθ = (r/w v_r + (w² - r²)/2w ∂v_r/∂r)/r̄
/// Further out r̄ = r and D_θθ = v_r/r. Without folding A = V/2πr has no bound as a particle comes near the axis.
struct RingSection {
  double mean_radius;  ///< r̄, m
  double share;        ///< of v_r in r̄ D_θθ
  double arm;          ///< of ∂v_r/∂r in r̄ D_θθ, m
};

/// That of a ring of volume V = 2πr̄ A in m³ about the radius r in m: w is the root of w³ + r² w = V/4π. Where r < 0, on
/// the way through the axis within a step, v_r counts outward beyond it.
inline RingSection section_of_ring(double radius, double volume) {
  const double half = volume / (8.0 * std::numbers::pi);  // V/8π: half of w³ + r² w
  const double cube = std::abs(radius * radius * radius);
  if (cube >= half) return {std::abs(radius), radius < 0.0 ? -1.0 : 1.0, 0.0};
  const double square = radius * radius;
  const double cardano = std::cbrt(half + std::sqrt(half * half + cube * cube / 27.0));
  const double w = cardano - square / (3.0 * cardano);
  return {(square + w * w) / (2.0 * w), radius / w, (w * w - square) / (2.0 * w)};
}

}  // namespace tektite
