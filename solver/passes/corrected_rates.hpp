#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "core/pack.hpp"
#include "passes/corrected_record.hpp"
#include "passes/far.hpp"
#include "passes/kernel_pair.hpp"
#include "passes/strain_rate_record.hpp"

namespace tektite {

/// The switch of Young et al. (2021), section 3.2: a pair takes the plain gradient where any component of the corrected
/// one differs from it by more than the factor C_f, or in sign. Components along which the pair is level, where both
/// vanish, are not asked.
struct CorrectionSwitch {
  double limit;  ///< C_f; infinite for no switch

  template <int D>
  Vector<Pack, D> choose(const Vector<Pack, D>& corrected, const Vector<Pack, D>& plain, const Vector<Pack, D>& x,
                         const Pack& h) const {
    if (limit == std::numeric_limits<double>::infinity()) return corrected;
    const Pack level = Pack(1e-3) * h;
    Pack apart = 0.0;  // how many components differ
    for (int k = 0; k < D; ++k) {
      using std::experimental::abs;
      const Pack product = corrected[k] * plain[k], square = plain[k] * plain[k];
      const Pack differs =
          select(product * Pack(limit) < square || product > Pack(limit) * square, Pack(1.0), Pack(0.0));
      apart += select(abs(x[k]) > level, differs, Pack(0.0));
    }
    Vector<Pack, D> chosen;
    for (int k = 0; k < D; ++k) chosen[k] = select(apart > Pack(0.0), plain[k], corrected[k]);
    return chosen;
  }
};

/// The sums of Young et al. (2021), eq. 1, with corrected gradients and artificial stress:
///   L_a = Σ V_b (v_b - v_a) ⊗ ∇̃_aW̃_ab
///   a_a = -(1/m_a) Σ V_a V_b (σ_b ∇̃_bW̃_ba - σ_a ∇̃_aW̃_ab) + Σ ½ m_b Π (∇̃_bW̃_ba - ∇̃_aW̃_ab)
///         - Σ ½ m_b fⁿ (R_b ∇̃_bW̃_ba - R_a ∇̃_aW̃_ab)
///   q_a = half the power of the last two sums' forces on the pair, with the other sign; the factor that is printed for
///         artificial stress does not conserve energy
/// Neighbours may be total-Lagrangian, with the Cauchy stress that they have; results are for Eulerian particles alone.
template <class Kernel, class Viscosity, int D, bool corrected, bool artificial>
struct CorrectedRates {
  using Record = CorrectedRecord<D>;
  using OwnCorrection = std::conditional_t<corrected, Correction<Pack, D>, PlainGradient<Pack, D>>;
  static constexpr int stresses = EulerianRecord<D>::stresses;

  const Record* records;
  Viscosity viscosity;
  CorrectionSwitch correction_switch;
  int exponent;  ///< n_as
  Vector<double, D>* acceleration;
  Tensor<double, D>* velocity_gradient;
  double* viscous_power;                              ///< q in W/kg
  double* viscous_signal;                             ///< largest |μ| in m/s
  const StrainRateRecord<D>* strain_rates = nullptr;  ///< where the viscosity reconstructs velocities

  struct Self {
    Vector<Pack, D> x, v;
    Pack stress[stresses], artificial_stress[stresses];
    Pack density, sound_speed, h, spacing;
    OwnCorrection correction;
    Vector<Pack, StrainRateRecord<D>::components> rate;
  };
  struct Sums {
    Vector<Pack, D> force = Vector<Pack, D>::zero();  ///< Σ V_b (σ_a ∇̃_a - σ_b ∇̃_b)
    Vector<Pack, D> other = Vector<Pack, D>::zero();  ///< viscosity and artificial stress
    Tensor<Pack, D> gradient = Tensor<Pack, D>::zero();
    Pack heat = 0.0;
    Pack signal = 0.0;
  };

  Self begin(std::size_t i) const {
    const Record& r = records[i];
    Self a;
    a.x = broadcast(r.x);
    a.v = broadcast(r.v);
    if constexpr (corrected) a.correction = broadcast(r.correction);
    broadcast(r.stress, a.stress);
    broadcast(r.artificial, a.artificial_stress);
    a.density = r.density;
    a.sound_speed = r.sound_speed;
    a.h = r.smoothing_length;
    a.spacing = r.spacing;
    if constexpr (Viscosity::reconstructs) a.rate = own(strain_rates, i, &StrainRateRecord<D>::rate);
    return a;
  }

  bool far(const Self& a, const std::uint32_t* j) const { return all_far<Kernel>(a, records, j, MeanSmoothing{}); }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto x = a.x - gathered(records, j, &Record::x);
    const auto v = a.v - gathered(records, j, &Record::v);
    const Pack h = Pack(0.5) * (a.h + gathered(records, j, &Record::smoothing_length));
    const KernelPair<Kernel, D> pair(x, h);
    const auto here = gradient(a.correction, pair.slope, pair.value, x, h);                    // ∇̃_aW̃_ab
    const auto there = gradient(correction_at(j), Pack(-1.0) * pair.slope, pair.value, x, h);  // ∇̃_bW̃_ba

    // What fills a list up is the particle itself, whose corrected gradient is not zero.
    const Pack volume = gathered(records, j, &Record::volume) * is_other(x);
    const Pack density = gathered(records, j, &Record::density);
    Pack stress[stresses];
    gather_into(stress, records, j, &Record::stress);
    const auto pull = difference(a.stress, here, stress, there);
    Vector<Pack, D> other;  // per m_b
    const Pack c = Pack(0.5) * (a.sound_speed + gathered(records, j, &Record::sound_speed));
    const Pack approach = damped_approach<Viscosity>(strain_rates, j, a.rate, x, dot(v, x));
    const auto [pi, speed] = viscosity(approach, dot(x, x), h, c, Pack(0.5) * (a.density + density));
    for (int k = 0; k < D; ++k) other[k] = Pack(0.5) * pi * (there[k] - here[k]);
    if constexpr (artificial) {
      Pack r[stresses];
      gather_into(r, records, j, &Record::artificial);
      const auto push = difference(a.artificial_stress, here, r, there);
      const Pack spacing = Pack(0.5) * (a.spacing + gathered(records, j, &Record::spacing));
      const Pack factor =
          Pack(0.5) * gathered(records, j, &Record::pushes) * closeness<Kernel, D>(pair.value, spacing, h, exponent);
      for (int k = 0; k < D; ++k) other[k] += factor * push[k];
    }
    const Pack mass = volume * density;
    for (int k = 0; k < D; ++k) {
      sums.force[k] += volume * pull[k];
      sums.other[k] += mass * other[k];
      const Pack across = volume * v[k];
      for (int m = 0; m < D; ++m) sums.gradient(k, m) -= across * here[m];
    }
    sums.heat += mass * dot(v, other);
    sums.signal = larger(sums.signal, select(pair.value * volume > Pack(0.0), speed, Pack(0.0)));
  }

  void end(std::size_t i, const Sums& sums) const {
    if (records[i].eulerian == 0.0) return;
    const double one_over_density = 1.0 / records[i].density;
    for (int k = 0; k < D; ++k) acceleration[i][k] = one_over_density * sum(sums.force[k]) + sum(sums.other[k]);
    for (int k = 0; k < D * D; ++k) velocity_gradient[i].c[k] = sum(sums.gradient.c[k]);
    viscous_power[i] = -0.5 * sum(sums.heat);
    viscous_signal[i] = largest(sums.signal);
  }

 private:
  OwnCorrection correction_at(const std::uint32_t* j) const {
    if constexpr (corrected)
      return gathered(records, j, &Record::correction);
    else
      return {};
  }
  Vector<Pack, D> gradient(const OwnCorrection& correction, const Vector<Pack, D>& plain, const Pack& value,
                           const Vector<Pack, D>& x, const Pack& h) const {
    if constexpr (corrected)
      return correction_switch.choose<D>(correction.gradient(plain, value), plain, x, h);
    else
      return plain;
  }
  /// s ∇̃_a - t ∇̃_b
  static Vector<Pack, D> difference(const Pack (&s)[stresses], const Vector<Pack, D>& here, const Pack (&t)[stresses],
                                    const Vector<Pack, D>& there) {
    auto result = Vector<Pack, D>::zero();
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < D; ++k) {
        const int n = EulerianRecord<D>::index(i, k);
        result[i] += s[n] * here[k] - t[n] * there[k];
      }
    return result;
  }
};

}  // namespace tektite
