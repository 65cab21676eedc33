#pragma once
// The exact motion of a collapsing ring of incompressible, rigid and perfectly plastic material in plane strain (Howell
// and Ball 2002): with q = a |da/dt| the velocity is -q/r, the kinetic energy π ρ q² ln(b/a) per length, and plastic
// flow takes (4π/√3) Y q ln(b/a) of it per time; b² - a² stays as it is.

#include <cmath>

namespace tektite::test {

struct Ring {
  double density = 0.0;             ///< kg/m³
  double flow_stress = 0.0;         ///< Pa
  double inner = 0.0, outer = 0.0;  ///< m
  double speed = 0.0;               ///< of the inner surface, inward, m/s
  double time = 0.0;                ///< s

  /// Follows the motion to a time, or to where it stops, by steps of the classical Runge-Kutta method.
  void advance_to(double end) {
    constexpr int steps = 20000;  // an error of (1/20000)⁴ of the way
    const double dt = (end - time) / steps;
    const double area = outer * outer - inner * inner;
    State now{inner, speed * inner};
    for (int k = 0; k < steps; ++k) {
      const auto one = rates(now, area), two = rates(plus(now, 0.5 * dt, one), area),
                 three = rates(plus(now, 0.5 * dt, two), area), four = rates(plus(now, dt, three), area);
      State next = now;
      next.a += dt / 6.0 * (one.a + 2.0 * (two.a + three.a) + four.a);
      next.q += dt / 6.0 * (one.q + 2.0 * (two.q + three.q) + four.q);
      if (next.q <= 0.0) {
        now.q = 0.0;
        break;
      }
      now = next;
      time += dt;
    }
    inner = now.a;
    outer = std::sqrt(now.a * now.a + area);
    speed = now.q / now.a;
  }

 private:
  struct State {
    double a, q;
  };
  static State plus(const State& state, double dt, const State& rate) {
    return {state.a + dt * rate.a, state.q + dt * rate.q};
  }
  /// da/dt = -q/a and, from d(π ρ q² L)/dt = -(4π/√3) Y q L with L = ln(b/a), dq/dt.
  State rates(const State& s, double area) const {
    const double square = s.a * s.a + area;
    const double logarithm = 0.5 * std::log(square / (s.a * s.a));
    const double inward = -s.q / s.a;
    const double logarithm_rate = inward * (s.a / square - 1.0 / s.a);
    return {inward,
            -(4.0 / std::sqrt(3.0) * flow_stress / density * logarithm + s.q * logarithm_rate) / (2.0 * logarithm)};
  }
};

}  // namespace tektite::test
