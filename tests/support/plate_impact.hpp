#pragma once
// The exact solution of a plate at a speed V on an equal one at rest, elastic and perfectly plastic, in uniaxial
// strain: into either plate runs an elastic precursor, which brings it to the yield condition, and a plastic shock,
// which brings it to V/2. Both are shocks, so density, stress, velocity and energy follow from the jump conditions
// alone, for any equation of state p(ρ, e). Holds where the plastic shock is slower than the precursor.

#include <cmath>

namespace tektite::test {

struct PlateState {
  double density = 0.0;   ///< kg/m³
  double stress = 0.0;    ///< along the impact, compression positive, Pa
  double velocity = 0.0;  ///< m/s
  double energy = 0.0;    ///< specific internal, J/kg
};

template <class Eos>
class PlateImpact {
 public:
  /// Shear modulus and flow stress in Pa, speed V in m/s.
  PlateImpact(const Eos& eos, double shear_modulus, double flow_stress, double speed)
      : eos_(eos), flow_stress_(flow_stress), speed_(speed) {
    const PlateState rest{eos.reference_density, 0.0, 0.0, 0.0};
    // s_xx = -4/3 G ln(ρ/ρ0) reaches 2/3 Y
    precursor_ = behind_shock(rest, eos.reference_density * std::exp(0.5 * flow_stress / shear_modulus));
    precursor_speed_ = shock_speed(rest, precursor_);
    double low = precursor_.density, high = 2.0 * low;
    for (int k = 0; k < 200; ++k) {
      const double middle = 0.5 * (low + high);
      (behind_shock(precursor_, middle).velocity < 0.5 * speed ? low : high) = middle;
    }
    shocked_ = behind_shock(precursor_, low);
    shock_speed_ = shock_speed(precursor_, shocked_);
  }

  /// Behind the precursor and behind the plastic shock, in the plate at rest.
  PlateState precursor() const { return precursor_; }
  PlateState shocked() const { return shocked_; }
  /// Speeds of both fronts against the plate at rest, m/s.
  double precursor_speed() const { return precursor_speed_; }
  double shock_speed() const { return shock_speed_; }

  /// The state at a place x in m, counted from where the plates met, at time t in s after that.
  PlateState at(double x, double t) const {
    const double from_contact = x - 0.5 * speed_ * t;
    const double ahead = std::abs(from_contact) + 0.5 * speed_ * t;
    PlateState state{eos_.reference_density, 0.0, 0.0, 0.0};
    if (ahead < precursor_speed_ * t) state = precursor_;
    if (ahead < shock_speed_ * t) state = shocked_;
    if (from_contact < 0.0) state.velocity = speed_ - state.velocity;
    return state;
  }

 private:
  /// Behind a shock to this density, at yield: e - e0 = (σ + σ0)/2 (1/ρ0 - 1/ρ), (v - v0)² = (σ - σ0)(1/ρ0 - 1/ρ).
  PlateState behind_shock(const PlateState& ahead, double density) const {
    const double squeeze = 1.0 / ahead.density - 1.0 / density;
    PlateState state{density, 0.0, 0.0, ahead.energy};
    for (int k = 0; k < 100; ++k) {  // contracts by the small factor Γ ζ/2
      state.stress = eos_.pressure(density, state.energy) + 2.0 / 3.0 * flow_stress_;
      state.energy = ahead.energy + 0.5 * (state.stress + ahead.stress) * squeeze;
    }
    state.velocity = ahead.velocity + std::sqrt((state.stress - ahead.stress) * squeeze);
    return state;
  }
  static double shock_speed(const PlateState& ahead, const PlateState& behind) {
    return (behind.density * behind.velocity - ahead.density * ahead.velocity) / (behind.density - ahead.density);
  }

  Eos eos_;
  double flow_stress_, speed_;
  PlateState precursor_, shocked_;
  double precursor_speed_ = 0.0, shock_speed_ = 0.0;
};

}  // namespace tektite::test
