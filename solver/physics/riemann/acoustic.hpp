#pragma once

#include <array>

#include "physics/model.hpp"
#include "physics/riemann/wave.hpp"

namespace tektite {

/// Both waves are sound: the time-split Godunov paper, eq. 15, with z = ρ c,
///   v* = (z_l v_l + z_r v_r + p_l - p_r)/(z_l + z_r),  p* = (z_l p_r + z_r p_l + z_l z_r (v_l - v_r))/(z_l + z_r).
/// The printed signs belong to a unit vector that points from i to j; here and in the schemes it points from the left
/// side j to the right side i, as its definition after eq. 14 has it.
struct AcousticRiemann {
  static constexpr std::string_view name = "acoustic";
  static std::array<Parameter<AcousticRiemann>, 0> parameters() { return {}; }

  template <class T>
  RiemannStar<T> operator()(const RiemannSide<T>& l, const RiemannSide<T>& r) const {
    const T zl = l.density * l.sound_speed;
    const T zr = r.density * r.sound_speed;
    const T inverse = T(1.0) / (zl + zr);
    return {(zl * r.pressure + zr * l.pressure + zl * zr * (l.velocity - r.velocity)) * inverse,
            (zl * l.velocity + zr * r.velocity + l.pressure - r.pressure) * inverse};
  }
};

}  // namespace tektite
