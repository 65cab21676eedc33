#pragma once

#include <array>
#include <cmath>

#include "core/pack.hpp"
#include "physics/model.hpp"
#include "physics/riemann/acoustic.hpp"
#include "physics/riemann/wave.hpp"

namespace tektite {

/// Exact for the stiffened gas that has a side's density, pressure, sound speed and shock slope:
///   γ = 4 A - 1,  p∞ = ρ c²/γ - p
/// (Toro 2009, section 4.3, with p + p∞ for p). Newton's iteration for p*; the change of velocity across a wave is a
/// rising, concave function of p*, so after its first step it comes from below and cannot overshoot. A material that is
/// no stiffened gas is taken for the one that touches it. The reference for the other solvers, and the slowest.
struct ExactRiemann {
  static constexpr std::string_view name = "exact";
  static std::array<Parameter<ExactRiemann>, 0> parameters() { return {}; }

  /// Never woven into the loops over pairs: as a reference it need not be fast, and the loops compile sooner.
  template <class T>
  [[gnu::noinline]] RiemannStar<T> operator()(const RiemannSide<T>& l, const RiemannSide<T>& r) const {
    const Gas<T> left(l), right(r);
    const T vacuum = larger(-left.stiffness, -right.stiffness);
    // What a gas without pressure meets another one with gives the scale where there is none else.
    const T closing = larger(l.velocity - r.velocity, T(0.0));
    const T ram = T(0.25) * smaller(l.density, r.density) * closing * closing + T(1e-280);
    const T scale = larger(larger(l.pressure + left.stiffness, r.pressure + right.stiffness), ram);
    const T least = vacuum + T(1e-12) * scale;
    const T acoustic = AcousticRiemann{}(l, r).pressure;  // no number where both sides have no sound speed
    T p = larger(select(acoustic > least, acoustic, least), ram);
    T change_l, change_r;
    constexpr int most = 60;
    for (int k = 0; k < most; ++k) {
      T slope_l, slope_r;
      left.wave(p, change_l, slope_l);
      right.wave(p, change_r, slope_r);
      const T next = larger(p - (change_l + change_r + r.velocity - l.velocity) / (slope_l + slope_r), least);
      const T move = larger(next - p, p - next);
      p = next;
      if (greatest(move / scale) <= 1e-15) break;
    }
    return {p, T(0.5) * (l.velocity + r.velocity + change_r - change_l)};
  }

 private:
  template <class T>
  struct Gas {
    T pressure, density, sound_speed;
    T gamma;  ///< kept above 1, which is the limit of the formulas below and not in their range
    T stiffness;

    explicit Gas(const RiemannSide<T>& side)
        : pressure(side.pressure),
          density(side.density),
          sound_speed(side.sound_speed),
          gamma(larger(T(4.0) * side.shock_slope - T(1.0), T(1.0 + 1e-6))),
          stiffness(density * sound_speed * sound_speed / gamma - pressure) {}

    /// Change of velocity across the wave that brings this side to p*, above zero where it compresses, and its slope.
    void wave(const T& star, T& change, T& slope) const {
      using std::exp;
      using std::expm1;
      using std::log;
      using std::sqrt;
      const T ahead = pressure + stiffness, behind = star + stiffness;
      const T a = T(2.0) / ((gamma + T(1.0)) * density), b = (gamma - T(1.0)) / (gamma + T(1.0)) * ahead;
      const T root = sqrt(a / (behind + b));
      const T shock = (star - pressure) * root;
      const T shock_slope = root * (T(1.0) - T(0.5) * (star - pressure) / (behind + b));
      const T logarithm = log(behind / ahead);
      const T power = T(0.5) * (gamma - T(1.0)) / gamma;
      const T fan = T(2.0) * sound_speed / (gamma - T(1.0)) * expm1(power * logarithm);
      const T fan_slope = exp(-T(0.5) * (gamma + T(1.0)) / gamma * logarithm) / (density * sound_speed);
      change = select(star > pressure, shock, fan);
      slope = select(star > pressure, shock_slope, fan_slope);
    }
  };

  static double greatest(double a) { return a; }
  static double greatest(const Pack& a) { return largest(a); }
};

}  // namespace tektite
