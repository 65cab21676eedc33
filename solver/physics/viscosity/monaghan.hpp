#pragma once

#include <array>

#include "core/pack.hpp"
#include "physics/model.hpp"

namespace tektite {

/// The term of a pair, Young et al. (2021), eq. 6 and 7:
///   Π = (-α c̄ μ + β μ²)/ρ̄ for approaching particles, μ = h v_ij·x_ij/(r² + 0.01 h²).
struct MonaghanPair {
  double alpha = 0.0;
  double beta = 0.0;

  template <class M>
  static auto parameters_of() {
    return std::array{Parameter<M>{"alpha", &M::alpha, dimension::none, {0.0, 10.0}, "linear coefficient α", 1.0},
                      Parameter<M>{"beta", &M::beta, dimension::none, {0.0, 10.0}, "quadratic coefficient β", 2.0}};
  }

  template <class T>
  struct Pair {
    T pi;     ///< Π in m⁵/(kg s²), so that m Π ∇W is an acceleration
    T speed;  ///< |μ| in m/s, zero for receding particles
  };

  /// approach = v_ij·x_ij in m²/s; c̄ and ρ̄ are the pair's means.
  template <class T>
  Pair<T> operator()(const T& approach, const T& r_squared, const T& h, const T& c, const T& rho) const {
    const T near = r_squared + T(0.01) * h * h;
    const T inverse = T(1.0) / (near * rho);  // one division serves μ and Π
    const T mu = smaller(approach, T(0.0)) * h * (inverse * rho);
    return {mu * (T(beta) * mu - T(alpha) * c) * (inverse * near), -mu};
  }
};

/// Monaghan's artificial viscosity: that term of the velocities as they are.
struct MonaghanViscosity : MonaghanPair {
  static constexpr std::string_view name = "monaghan";
  static constexpr bool reconstructs = false;  ///< velocities to the middle of a pair

  static auto parameters() { return parameters_of<MonaghanViscosity>(); }
};

}  // namespace tektite
