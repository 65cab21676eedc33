#pragma once
// The exact solution of a Riemann problem without strength, for any equation of state p(ρ, e) whose waves are single
// shocks and single rarefactions. Nothing of the model but its pressure is used: shocks follow from the jump conditions
// (Hugoniot), rarefactions from the isentrope de = p dρ/ρ² and dv = ±c dρ/ρ, c² = dp/dρ along it.

#include <algorithm>
#include <cmath>
#include <vector>

namespace tektite::test {

struct FluidState {
  double density = 0.0;   ///< kg/m³
  double velocity = 0.0;  ///< m/s
  double energy = 0.0;    ///< specific internal, J/kg
  double pressure = 0.0;  ///< Pa
};

template <class Eos>
class RiemannProblem {
 public:
  /// Left and right states by density, velocity and energy; their pressure is worked out here.
  RiemannProblem(const Eos& eos, FluidState left, FluidState right) : eos_(eos), left_(left), right_(right) {
    left_.pressure = eos_.pressure(left_.density, left_.energy);
    right_.pressure = eos_.pressure(right_.density, right_.energy);
    left_fan_ = isentrope(left_);
    right_fan_ = isentrope(right_);
    meet();
  }

  double contact_pressure() const { return pressure_; }
  double contact_velocity() const { return velocity_; }
  FluidState behind_left() const { return left_behind_; }
  FluidState behind_right() const { return right_behind_; }

  /// The state at x/t = ξ in m/s.
  FluidState at(double xi) const {
    if (xi < velocity_) return side(left_, left_behind_, left_fan_, xi, -1.0);
    return side(right_, right_behind_, right_fan_, xi, 1.0);
  }

 private:
  struct FanPoint {
    FluidState state;
    double drop = 0.0;         ///< ∫ c dρ/ρ from here up to the undisturbed state, m/s
    double sound_speed = 0.0;  ///< m/s
  };
  using Fan = std::vector<FanPoint>;

  double sound_speed(double rho, double e) const {
    // The central difference along the isentrope: an error of (1e-5)².
    const double dr = 1e-5 * rho;
    const double de = eos_.pressure(rho, e) / (rho * rho) * dr;
    return std::sqrt((eos_.pressure(rho + dr, e + de) - eos_.pressure(rho - dr, e - de)) / (2.0 * dr));
  }

  /// From a state down to a third of its density, or to where the sound speed ends, by the midpoint rule.
  Fan isentrope(const FluidState& start) const {
    constexpr int points = 20000;  // an error of (1/20000)²
    const double ratio = std::pow(1.0 / 3.0, 1.0 / points);
    Fan fan{{start, 0.0, sound_speed(start.density, start.energy)}};
    for (int k = 0; k < points; ++k) {
      const auto& from = fan.back();
      const double rho = from.state.density, next = ratio * rho, middle = 0.5 * (rho + next);
      const double e_middle = from.state.energy + from.state.pressure / (rho * rho) * (middle - rho);
      const double p_middle = eos_.pressure(middle, e_middle);
      const double c_middle = sound_speed(middle, e_middle);
      if (!(c_middle > 0.0)) break;
      FanPoint to{{next, 0.0, from.state.energy + p_middle / (middle * middle) * (next - rho), 0.0}, 0.0, 0.0};
      to.state.pressure = eos_.pressure(next, to.state.energy);
      to.drop = from.drop + c_middle / middle * (rho - next);
      to.sound_speed = sound_speed(next, to.state.energy);
      fan.push_back(to);
    }
    return fan;
  }

  /// Behind a shock that brings `ahead` to this density: e - e0 = (p + p0)/2 (1/ρ0 - 1/ρ).
  FluidState shocked(const FluidState& ahead, double rho) const {
    const double squeeze = 0.5 * (1.0 / ahead.density - 1.0 / rho);
    const auto excess = [&](double e) { return e - ahead.energy - squeeze * (eos_.pressure(rho, e) + ahead.pressure); };
    double e = ahead.energy;
    for (int k = 0; k < 50; ++k) {  // Newton; one step where p is linear in e
      const double width = 1e-3 * (std::abs(e) + 1.0);
      const double step = excess(e) * width / (excess(e + width) - excess(e));
      e -= step;
      if (std::abs(step) <= 1e-13 * std::abs(e)) break;
    }
    return {rho, 0.0, e, eos_.pressure(rho, e)};
  }

  /// The state behind the wave that brings `ahead` to a pressure, with the change of speed in `velocity`: above zero
  /// where the wave compresses.
  FluidState behind(const FluidState& ahead, const Fan& fan, double pressure) const {
    if (pressure <= ahead.pressure) {
      const auto point = along(
          fan, [](const FanPoint& p) { return p.state.pressure; }, pressure);
      return {point.state.density, -point.drop, point.state.energy, pressure};
    }
    double low = ahead.density, high = 1.01 * ahead.density;
    while (shocked(ahead, high).pressure < pressure) high = low + 1.2 * (high - low);
    for (int k = 0; k < 100; ++k) {
      const double middle = 0.5 * (low + high);
      (shocked(ahead, middle).pressure < pressure ? low : high) = middle;
    }
    auto state = shocked(ahead, high);
    state.velocity = std::sqrt((state.pressure - ahead.pressure) * (1.0 / ahead.density - 1.0 / state.density));
    return state;
  }

  /// Where along a fan a quantity, which falls along it, has fallen to `wanted`; its end where it never does.
  template <class Quantity>
  static FanPoint along(const Fan& fan, const Quantity& quantity, double wanted) {
    const auto below = std::ranges::partition_point(fan, [&](const FanPoint& p) { return quantity(p) > wanted; });
    if (below == fan.begin()) return fan.front();
    if (below == fan.end()) return fan.back();
    const auto &a = *(below - 1), &b = *below;
    const double part = (quantity(a) - wanted) / (quantity(a) - quantity(b));
    const auto between = [&](double from, double to) { return from + part * (to - from); };
    return {{between(a.state.density, b.state.density), 0.0, between(a.state.energy, b.state.energy),
             between(a.state.pressure, b.state.pressure)},
            between(a.drop, b.drop),
            between(a.sound_speed, b.sound_speed)};
  }

  /// Bisection for the pressure at which both sides have one velocity.
  void meet() {
    double low = std::min(left_fan_.back().state.pressure, right_fan_.back().state.pressure);
    double high = 2.0 * std::max(left_.pressure, right_.pressure) +
                  left_.density * std::pow(left_.velocity - right_.velocity, 2) +
                  left_.density * left_fan_.front().sound_speed * std::abs(left_.velocity - right_.velocity);
    for (int k = 0; k < 60; ++k) {
      pressure_ = 0.5 * (low + high);
      left_behind_ = behind(left_, left_fan_, pressure_);
      right_behind_ = behind(right_, right_fan_, pressure_);
      left_behind_.velocity = left_.velocity - left_behind_.velocity;
      right_behind_.velocity = right_.velocity + right_behind_.velocity;
      (left_behind_.velocity > right_behind_.velocity ? low : high) = pressure_;
    }
    velocity_ = 0.5 * (left_behind_.velocity + right_behind_.velocity);
  }

  /// One side of the contact; `direction` is that in which its wave runs.
  FluidState side(const FluidState& ahead, const FluidState& behind, const Fan& fan, double xi,
                  double direction) const {
    if (behind.pressure > ahead.pressure) {
      const double front =
          (behind.density * behind.velocity - ahead.density * ahead.velocity) / (behind.density - ahead.density);
      return direction * (xi - front) > 0.0 ? ahead : behind;
    }
    const auto speed = [&](const FanPoint& p) {  // of the characteristic, away from the contact
      return direction * ahead.velocity - p.drop + p.sound_speed;
    };
    if (direction * xi >= speed(fan.front())) return ahead;
    const auto point = along(fan, speed, direction * xi);
    if (point.state.pressure <= behind.pressure) return behind;
    auto state = point.state;
    state.velocity = ahead.velocity - direction * point.drop;
    return state;
  }

  Eos eos_;
  FluidState left_, right_, left_behind_, right_behind_;
  Fan left_fan_, right_fan_;
  double pressure_ = 0.0;
  double velocity_ = 0.0;
};

}  // namespace tektite::test
