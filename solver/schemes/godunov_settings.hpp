#pragma once

#include <string>

#include "core/space.hpp"
#include "physics/limiters/limiter.hpp"
#include "physics/riemann/riemann.hpp"

namespace tektite {

/// What the Godunov schemes are asked for beside the Courant number and the kernel.
struct GodunovSettings {
  int order = 2;        ///< in space
  bool strang = false;  ///< Strang's splitting, of second order in time; otherwise that of Lie and Trotter
  Riemann riemann;
  Limiter limiter;  ///< of second order; first order has no slopes, but `order` can be changed alone
};

/// Reads `order`, `splitting`, `riemann` and `limiter` of [scheme].
GodunovSettings read_godunov(Section& scheme, Space space);

}  // namespace tektite
