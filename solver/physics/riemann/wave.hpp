#pragma once

namespace tektite {

/// What a Riemann solver sees of one side of a contact, along the unit vector that points from left to right. For
/// double and Pack (core/pack.hpp) alike.
template <class T>
struct RiemannSide {
  T pressure;       ///< Pa, compression positive
  T velocity;       ///< m/s
  T density;        ///< kg/m³
  T sound_speed;    ///< m/s
  T shock_slope;    ///< A in u_s = c + A Δu, the speed of a weak shock over the jump of velocity
                    ///< (physics/eos/shock_slope.hpp)
  T inverse_slope;  ///< 1/A, kept beside it to save divisions
};

/// What both sides agree on once they have met.
template <class T>
struct RiemannStar {
  T pressure;  ///< Pa
  T velocity;  ///< m/s
};

}  // namespace tektite
