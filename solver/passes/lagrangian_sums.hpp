#pragma once

#include <cstdint>
#include <type_traits>

#include "core/pack.hpp"
#include "passes/kernel_pair.hpp"
#include "passes/lagrangian_records.hpp"
#include "passes/transposed.hpp"

namespace tektite {

/// Two particles in the reference configuration: X_a - X_b, mean smoothing length, W and ∇_0W.
template <class T, int D>
struct ReferencePair {
  Vector<T, D> x;
  T h;
  T value;
  Vector<T, D> slope;
};

/// The records of particles with lists of neighbours ...
template <int D>
struct ListedRecords {
  using Number = Pack;
  using Own = std::size_t;
  using Index = const std::uint32_t*;
  const ReferenceRecord<D>* reference;
  const MotionRecord<D>* motion;
  const StressRecord<D>* stress;
};

/// ... and those of a lattice.
template <int D>
struct LatticeRecords {
  using Number = WidePack;
  using Own = LatticeCell;
  using Index = LatticeCell;
  Transposed<ReferenceRecord<D>> reference;
  Transposed<MotionRecord<D>> motion;
  Transposed<StressRecord<D>> stress;
};

/// How the sums of a pass leave it: over the lanes, where these are neighbours of one particle ...
struct OverLanes {
  double sum(const Pack& a) const { return tektite::sum(a); }
  double largest(const Pack& a) const { return tektite::largest(a); }
};
/// ... or from one of them, where each is a particle.
struct OneLane {
  std::size_t lane;
  double sum(const WidePack& a) const { return a[lane]; }
  double largest(const WidePack& a) const { return a[lane]; }
};

/// What both sums below do alike: pass.meet(self, pair, j, weight, sums) is the physics of a pair, `weight` being zero
/// in lanes without a neighbour, and pass.leave(i, sums, lanes) writes.
template <class Pass, class Kernel, int D, bool corrected, class Records>
struct ReferenceSums {
  using Number = typename Records::Number;
  Records records;

  using OwnCorrection = std::conditional_t<corrected, Correction<Number, D>, PlainGradient<Number, D>>;
  [[gnu::always_inline]] OwnCorrection correction_of(const typename Records::Own& i) const {
    if constexpr (corrected)
      return own(records.reference, i, &ReferenceRecord<D>::correction);
    else
      return {};
  }
  [[gnu::always_inline]] OwnCorrection correction_at(const typename Records::Index& j) const {
    if constexpr (corrected)
      return gathered(records.reference, j, &ReferenceRecord<D>::correction);
    else
      return {};
  }

  template <class Self, class Sums>
  [[gnu::always_inline]] void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto x = a.reference - gathered(records.reference, j, &ReferenceRecord<D>::x);
    const Pack h = Pack(0.5) * (a.h + gathered(records.reference, j, &ReferenceRecord<D>::smoothing_length));
    const KernelPair<Kernel, D> pair(x, h);
    pass().meet(a, {x, h, pair.value, pair.slope}, j, is_other(x), sums);
  }
  template <class Sums>
  [[gnu::always_inline]] void end(std::size_t i, const Sums& sums) const {
    pass().leave(i, sums, OverLanes{});
  }

  template <class Self, class Sums>
  [[gnu::always_inline]] void add(const Self& a, const ReferencePair<double, D>& pair, const LatticeCell& cell,
                                  Sums& sums) const {
    pass().meet(a, {broadcast<Number>(pair.x), pair.h, pair.value, broadcast<Number>(pair.slope)}, cell, Number(1.0),
                sums);
  }
  template <class Sums>
  [[gnu::always_inline]] void end(std::size_t i, const Sums& sums, std::size_t lane) const {
    pass().leave(i, sums, OneLane{lane});
  }

 private:
  const Pass& pass() const { return static_cast<const Pass&>(*this); }
};

/// Deformation of Young et al. (2021), eq. 2 and 13: F = I + Σ V_b0 (u_b - u_a) ⊗ ∇̃_0W̃ and its rate.
template <class Kernel, int D, bool corrected, class Records>
struct DeformationSums : ReferenceSums<DeformationSums<Kernel, D, corrected, Records>, Kernel, D, corrected, Records> {
  Tensor<double, D>* deformation;  ///< F
  Tensor<double, D>* rate;         ///< dF/dt, 1/s

  using Number = typename Records::Number;
  struct Self {
    Vector<Number, D> reference, x, v;
    Number h;
    typename DeformationSums::OwnCorrection correction;
  };
  struct Sums {
    Tensor<Number, D> displacement = Tensor<Number, D>::zero();
    Tensor<Number, D> rate = Tensor<Number, D>::zero();
  };

  [[gnu::always_inline]] Self begin(const typename Records::Own& i) const {
    const auto& [reference, motion, stress] = this->records;
    return {own(reference, i, &ReferenceRecord<D>::x), own(motion, i, &MotionRecord<D>::x),
            own(motion, i, &MotionRecord<D>::v), own(reference, i, &ReferenceRecord<D>::smoothing_length),
            this->correction_of(i)};
  }

  [[gnu::always_inline]] void meet(const Self& a, const ReferencePair<Number, D>& pair, typename Records::Index j,
                                   const Number& weight, Sums& sums) const {
    const auto& [reference, motion, stress] = this->records;
    const auto u = gathered(motion, j, &MotionRecord<D>::x) - a.x + pair.x;
    const auto v = gathered(motion, j, &MotionRecord<D>::v) - a.v;
    const Number volume = gathered(reference, j, &ReferenceRecord<D>::volume) * weight;
    const auto gradient = a.correction.gradient(pair.slope, pair.value);
    for (int r = 0; r < D; ++r)
      for (int c = 0; c < D; ++c) {
        sums.displacement(r, c) += volume * u[r] * gradient[c];
        sums.rate(r, c) += volume * v[r] * gradient[c];
      }
  }

  template <class Lanes>
  [[gnu::always_inline]] void leave(std::size_t i, const Sums& sums, const Lanes& lanes) const {
    for (int r = 0; r < D; ++r)
      for (int c = 0; c < D; ++c) {
        deformation[i](r, c) = (r == c ? 1.0 : 0.0) + lanes.sum(sums.displacement(r, c));
        rate[i](r, c) = lanes.sum(sums.rate(r, c));
      }
  }
};

/// Forces of Young et al. (2021), eq. 2:
///   a_a = -(1/m_a) Σ V_a0 V_b0 (P_b ∇̃_b0 W̃_ba - P_a ∇̃_a0 W̃_ab)
///       + Σ ½ m_b Π (J_a⁻¹ F_b⁻ᵀ ∇̃_b0 W̃_ba - J_b⁻¹ F_a⁻ᵀ ∇̃_a0 W̃_ab)
///   q_a = Σ ¼ m_b Π (v_b - v_a) · (the same bracket)
/// with m_b/(J_a J_b) = V_b0 ρ_b/J_a, J_a = m_a/(V_a0 ρ_a) and the cofactor C = J F⁻ᵀ. Two Eulerian particles do not
/// act on each other here.
template <class Kernel, class Viscosity, int D, bool corrected, class Records>
struct LagrangianForces
    : ReferenceSums<LagrangianForces<Kernel, Viscosity, D, corrected, Records>, Kernel, D, corrected, Records> {
  Viscosity viscosity;
  const ReferenceRecord<D>* reference;  ///< of particle i, wherever its neighbours are read
  const StressRecord<D>* stress;
  const double* mass;
  Vector<double, D>* acceleration;
  double* viscous_power;   ///< W/kg
  double* viscous_signal;  ///< m/s

  using Number = typename Records::Number;
  struct Self {
    Vector<Number, D> reference, x, v;
    Tensor<Number, D> cofactor;
    Number h, density, sound_speed, stretch;
    typename LagrangianForces::OwnCorrection correction;
  };
  struct Sums {
    Vector<Number, D> gradient = Vector<Number, D>::zero();  ///< Σ V_b0 ∇̃_a0 W̃_ab, by which P_a acts
    Vector<Number, D> pull = Vector<Number, D>::zero();
    Vector<Number, D> viscous = Vector<Number, D>::zero();
    Number heat = 0.0;
    Number signal = 0.0;
  };

  [[gnu::always_inline]] Self begin(const typename Records::Own& i) const {
    using Reference = ReferenceRecord<D>;
    using Stress = StressRecord<D>;
    const auto& r = this->records;
    return {own(r.reference, i, &Reference::x),
            own(r.motion, i, &MotionRecord<D>::x),
            own(r.motion, i, &MotionRecord<D>::v),
            own(r.stress, i, &Stress::cofactor),
            own(r.reference, i, &Reference::smoothing_length),
            own(r.stress, i, &Stress::density),
            own(r.stress, i, &Stress::sound_speed),
            own(r.stress, i, &Stress::least_stretch),
            this->correction_of(i)};
  }

  [[gnu::always_inline]] void meet(const Self& a, const ReferencePair<Number, D>& pair, typename Records::Index j,
                                   const Number& weight, Sums& sums) const {
    const auto& r = this->records;
    const auto x = a.x - gathered(r.motion, j, &MotionRecord<D>::x);
    const auto v = a.v - gathered(r.motion, j, &MotionRecord<D>::v);
    const Number volume = gathered(r.reference, j, &ReferenceRecord<D>::volume) * weight;

    const auto here = a.correction.gradient(pair.slope, pair.value);                            // ∇̃_a0 W̃_ab
    const auto there = this->correction_at(j).gradient(Number(-1.0) * pair.slope, pair.value);  // ∇̃_b0 W̃_ba
    const auto other_stress = gathered(r.stress, j, &StressRecord<D>::stress);
    const auto other_cofactor = gathered(r.stress, j, &StressRecord<D>::cofactor);
    const auto pull = times(other_stress, there);
    const auto bracket = times(other_cofactor, there) - times(a.cofactor, here);

    const Number approach = dot(v, x);
    const Number density = gathered(r.stress, j, &StressRecord<D>::density);
    const Number c = Number(0.5) * (a.sound_speed + gathered(r.stress, j, &StressRecord<D>::sound_speed));
    // Of the present configuration, as the places are: with h as it was at the start μ would grow as they come nearer.
    const Number h = pair.h * (Number(0.5) * (a.stretch + gathered(r.stress, j, &StressRecord<D>::least_stretch)));
    const auto [pi, speed] = viscosity(approach, dot(x, x), h, c, Number(0.5) * (a.density + density));
    // Where the deformation turns the gradients against the line between the particles, Π would drive them, not damp
    // them.
    const Number power = dot(v, bracket);
    const Number damping = select(power < Number(0.0), volume * density * pi, Number(0.0));
    for (int k = 0; k < D; ++k) {
      sums.gradient[k] += volume * here[k];
      sums.pull[k] += volume * pull[k];
      sums.viscous[k] += damping * bracket[k];
    }
    sums.heat += damping * power;
    sums.signal = larger(sums.signal, select(pair.value * volume > Number(0.0), speed, Number(0.0)));
  }

  template <class Lanes>
  [[gnu::always_inline]] void leave(std::size_t i, const Sums& sums, const Lanes& lanes) const {
    if (reference[i].lagrangian == 0.0) {
      acceleration[i] = Vector<double, D>::zero();
      viscous_power[i] = viscous_signal[i] = 0.0;
      return;
    }
    const double over_mass = reference[i].volume / mass[i];
    const double over_jacobian = over_mass * stress[i].density;
    Vector<double, D> gradient;
    for (int k = 0; k < D; ++k) gradient[k] = lanes.sum(sums.gradient[k]);
    const auto push = times(stress[i].stress, gradient);
    for (int k = 0; k < D; ++k)
      acceleration[i][k] =
          over_mass * (push[k] - lanes.sum(sums.pull[k])) + 0.5 * over_jacobian * lanes.sum(sums.viscous[k]);
    viscous_power[i] = -0.25 * over_jacobian * lanes.sum(sums.heat);
    viscous_signal[i] = lanes.largest(sums.signal);
  }
};

}  // namespace tektite
