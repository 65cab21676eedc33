#pragma once

#include <cstdint>
#include <limits>

#include "core/pack.hpp"
#include "passes/corrected_record.hpp"
#include "passes/kernel_pair.hpp"

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
template <class Kernel, class Viscosity, int D, bool artificial>
struct CorrectedRates {
  using Record = CorrectedRecord<D>;
  static constexpr int stresses = EulerianRecord<D>::stresses;

  const Record* records;
  Viscosity viscosity;
  CorrectionSwitch correction_switch;
  int exponent;  ///< n_as
  Vector<double, D>* acceleration;
  Tensor<double, D>* velocity_gradient;
  double* viscous_power;   ///< q in W/kg
  double* viscous_signal;  ///< largest |μ| in m/s

  struct Self {
    Vector<Pack, D> x, v;
    Pack stress[stresses], artificial_stress[stresses];
    Pack density, sound_speed, h, spacing;
    Correction<Pack, D> correction;
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
    for (int k = 0; k < D; ++k) {
      a.x[k] = r.x[k];
      a.v[k] = r.v[k];
      a.correction.shift[k] = r.correction.shift[k];
    }
    for (int k = 0; k < D * D; ++k) a.correction.matrix.c[k] = r.correction.matrix.c[k];
    for (int k = 0; k < stresses; ++k) {
      a.stress[k] = r.stress[k];
      a.artificial_stress[k] = r.artificial[k];
    }
    a.density = r.density;
    a.sound_speed = r.sound_speed;
    a.h = r.smoothing_length;
    a.spacing = r.spacing;
    return a;
  }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto gather = [&](auto member) {
      return Pack([&](auto lane) { return member(records[j[static_cast<std::size_t>(lane)]]); });
    };
    Vector<Pack, D> x, v;
    Correction<Pack, D> correction;
    for (int k = 0; k < D; ++k) {
      x[k] = a.x[k] - gather([k](const auto& r) { return r.x[k]; });
      v[k] = a.v[k] - gather([k](const auto& r) { return r.v[k]; });
      correction.shift[k] = gather([k](const auto& r) { return r.correction.shift[k]; });
    }
    for (int k = 0; k < D * D; ++k)
      correction.matrix.c[k] = gather([k](const auto& r) { return r.correction.matrix.c[k]; });
    const Pack h = Pack(0.5) * (a.h + gather([](const auto& r) { return r.smoothing_length; }));
    const KernelPair<Kernel, D> pair(x, h);
    const auto minus = Pack(-1.0) * pair.slope;
    const auto here =
        correction_switch.choose<D>(a.correction.gradient(pair.slope, pair.value), pair.slope, x, h);  // ∇̃_aW̃_ab
    const auto there = correction_switch.choose<D>(correction.gradient(minus, pair.value), minus, x, h);  // ∇̃_bW̃_ba

    // What fills a list up is the particle itself, whose corrected gradient is not zero.
    const Pack volume = gather([](const auto& r) { return r.volume; }) * is_other(x);
    const Pack density = gather([](const auto& r) { return r.density; });
    Pack stress[stresses];
    for (int k = 0; k < stresses; ++k) stress[k] = gather([k](const auto& r) { return r.stress[k]; });
    const auto pull = difference(a.stress, here, stress, there);
    Vector<Pack, D> other;  // per m_b
    const Pack c = Pack(0.5) * (a.sound_speed + gather([](const auto& r) { return r.sound_speed; }));
    const auto [pi, speed] = viscosity(dot(v, x), dot(x, x), h, c, Pack(0.5) * (a.density + density));
    for (int k = 0; k < D; ++k) other[k] = Pack(0.5) * pi * (there[k] - here[k]);
    if constexpr (artificial) {
      Pack r[stresses];
      for (int k = 0; k < stresses; ++k) r[k] = gather([k](const auto& record) { return record.artificial[k]; });
      const auto push = difference(a.artificial_stress, here, r, there);
      const Pack spacing = Pack(0.5) * (a.spacing + gather([](const auto& record) { return record.spacing; }));
      const Pack factor =
          Pack(0.5) * gather([](const auto& record) { return record.pushes; }) * closeness(pair.value, spacing, h);
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

  /// fⁿ, f = W_ab/W(Δp)
  Pack closeness(const Pack& value, const Pack& spacing, const Pack& h) const {
    auto apart = Vector<Pack, D>::zero();
    apart[0] = spacing;
    const Pack f = value / KernelPair<Kernel, D>(apart, h).value;
    Pack power = f;
    for (int k = 1; k < exponent; ++k) power *= f;
    return power;
  }
};

}  // namespace tektite
