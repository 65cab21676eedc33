#pragma once

#include "physics/limiters/van_leer.hpp"
#include "physics/viscosity/monaghan.hpp"

namespace tektite {

/// Monaghan's viscosity on velocities that are brought to the middle between both particles by their own gradients,
/// limited after van Leer: Frontiere, Raskin and Owen (2017), J. Comp. Phys. 332. Their v̂_ij·x_ij is
///   v_ij·x_ij - φ (a + b)/2,  a = x_ij·L_i x_ij,  b = x_ij·L_j x_ij,  φ = 4 ab/(a + b)² where both agree, else 0,
/// so what is taken off is van Leer's mean of a and b: a linear motion is not damped, a shock is. Their factor for
/// pairs that are nearer than the spacing is left out: it would damp metal that is pressed flat.
struct LimitedViscosity : MonaghanPair {
  static constexpr std::string_view name = "limited";
  static constexpr bool reconstructs = true;

  static auto parameters() { return parameters_of<LimitedViscosity>(); }

  /// What stands for v_ij·x_ij above; zero for particles that recede, so that only motion that approaches is damped.
  template <class T>
  static T reconstructed(const T& approach, const T& a, const T& b) {
    return select(approach < T(0.0), smaller(approach - VanLeerLimiter()(a, b), T(0.0)), T(0.0));
  }
};

}  // namespace tektite
