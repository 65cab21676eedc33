#pragma once

#include <string>

#include "physics/kernels/kernel.hpp"

namespace tektite {

/// W''(r) in units of σ_D/h^(D+2), whose sign is all that is asked of it. Throws nothing: an unknown kernel has zero.
inline double kernel_curvature(const std::string& kernel, double r, double h) {
  constexpr double step = 1e-6;  // of h; the slope is a polynomial or an exponential
  double curvature = 0.0;
  const auto of = [&]<class K>(std::type_identity<K>) {
    const auto slope = [](double q) { return q < K::support ? q * K::slope_over_q(q) : 0.0; };
    const double q = r / h;
    curvature = (slope(q + step) - slope(q - step)) / (2.0 * step);
  };
  [&]<class... Kernels>(std::type_identity<std::variant<Kernels...>>) {
    ((Kernels::name == kernel ? of(std::type_identity<Kernels>{}) : void()), ...);
  }(std::type_identity<Kernel>{});
  return curvature;
}

/// Whether neighbours at distance r are unstable under a stress (tension positive): Swegle, Hicks and Attaway (1995),
/// J. Comput. Phys. 116, 123: W''(r) σ > 0.
inline bool swegle_unstable(const std::string& kernel, double r, double h, double stress) {
  return kernel_curvature(kernel, r, h) * stress > 0.0;
}

}  // namespace tektite
