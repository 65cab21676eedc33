#pragma once

#include <array>
#include <cmath>

#include "core/pack.hpp"
#include "physics/model.hpp"
#include "physics/riemann/wave.hpp"

namespace tektite {

/// Both waves are shocks with u_s = c + A Δu: Dukowicz (1985), A general, non-iterative Riemann solver for Godunov's
/// method. On either side p* is a parabola of v*,
///   p* = p_r' + ρ_r A_r |v* - v_r'| (v* - v_r'),  v_r' = v_r - c_r/(2 A_r),  p_r' = p_r - ρ_r c_r²/(4 A_r),
///   p* = p_l' - ρ_l A_l |v* - v_l'| (v* - v_l'),  v_l' = v_l + c_l/(2 A_l),  p_l' = p_l - ρ_l c_l²/(4 A_l),
/// and their difference rises with v*, so its signs at v_r' and v_l' tell which branches meet: a quadratic is left.
struct TwoShockRiemann {
  static constexpr std::string_view name = "two-shock";
  static std::array<Parameter<TwoShockRiemann>, 0> parameters() { return {}; }

  template <class T>
  RiemannStar<T> operator()(const RiemannSide<T>& l, const RiemannSide<T>& r) const {
    using std::sqrt;
    const T br = r.density * r.shock_slope, bl = l.density * l.shock_slope;
    const T reach_r = T(0.5) * r.sound_speed * r.inverse_slope, reach_l = T(0.5) * l.sound_speed * l.inverse_slope;
    const T pr = r.pressure - br * reach_r * reach_r, pl = l.pressure - bl * reach_l * reach_l;
    const T vr = r.velocity - reach_r, vl = l.velocity + reach_l;
    // About the middle of v_r' and v_l', which lie half a width away: w = v* - middle.
    const T middle = T(0.5) * (vl + vr), half = T(0.5) * (vl - vr);
    const T jump = pr - pl;
    const T square = T(4.0) * half * larger(half, -half);
    const T ar = select(jump < bl * square, br, -br);
    const T al = select(jump < -br * square, bl, -bl);
    // a_r (w + half)² + a_l (w - half)² + p_r' - p_l' = 0, whose rising root is meant
    const T a = ar + al, b = (al - ar) * half, c = a * half * half + jump;
    const T root = sqrt(larger(b * b - a * c, T(0.0)));
    const T w = select(b < T(0.0), c, b + root) / select(b < T(0.0), b - root, a);
    const T by_right = pr + ar * (w + half) * (w + half), by_left = pl - al * (w - half) * (w - half);
    return {T(0.5) * (by_right + by_left), middle + w};
  }
};

}  // namespace tektite
