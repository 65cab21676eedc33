#pragma once

#include <cstdint>

#include "core/pack.hpp"
#include "core/tensor_product.hpp"
#include "passes/kernel_pair.hpp"
#include "passes/lagrangian_records.hpp"
#include "passes/strain_rate_record.hpp"
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
  const StressRecord<D>* stress = nullptr;           ///< where a pass reads them, as all that follow
  const ShiftRecord<D>* shift = nullptr;             ///< with a correction
  const HourglassRecord<D>* hourglass = nullptr;     ///< with control of zero-energy modes
  const StrainRateRecord<D>* strain_rate = nullptr;  ///< where the viscosity reconstructs velocities
};

/// ... and copies of those of a lattice.
template <int D>
struct LatticeRecords {
  using Number = WidePack;
  using Own = LatticePlace;
  using Index = LatticePlace;
  Transposed<ReferenceRecord<D>> reference;
  Transposed<MotionRecord<D>> motion;
  Transposed<StressRecord<D>> stress;
  Transposed<ShiftRecord<D>> shift;             ///< null without a correction
  Transposed<HourglassRecord<D>> hourglass;     ///< null where there is no control of zero-energy modes
  Transposed<StrainRateRecord<D>> strain_rate;  ///< null where the viscosity does not reconstruct velocities
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

/// Where the particles are, in the reference configuration; on a lattice the pairs know it.
template <class Records, int D>
struct OwnReference {
  Vector<Pack, D> x;
  Pack h;
  explicit OwnReference(const Records& records, std::size_t i)
      : x(own(records.reference, i, &ReferenceRecord<D>::x)),
        h(own(records.reference, i, &ReferenceRecord<D>::smoothing_length)) {}
};
template <int D>
struct OwnReference<LatticeRecords<D>, D> {
  explicit OwnReference(const LatticeRecords<D>&, LatticePlace) {}
};

/// What both sums below do alike: pass.meet(self, pair, j, sums) is the physics of a pair, whose kernel is zero in
/// lanes without a neighbour, and pass.leave(i, sums, lanes) writes.
template <class Pass, class Kernel, int D, class Records>
struct ReferenceSums {
  using Number = typename Records::Number;
  Records records;
  const ReferenceRecord<D>* reference;                 ///< of particle i, wherever its neighbours are read
  const Correction<double, D>* corrections = nullptr;  ///< of particle i, where gradients are corrected

  template <class Self, class Sums>
  [[gnu::always_inline]] void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto x = a.reference.x - gathered(records.reference, j, &ReferenceRecord<D>::x);
    const Pack h = Pack(0.5) * (a.reference.h + gathered(records.reference, j, &ReferenceRecord<D>::smoothing_length));
    const KernelPair<Kernel, D> pair(x, h);
    pass().meet(a, {x, h, pair.value * is_other(x), pair.slope}, j, sums);
  }
  template <class Sums>
  [[gnu::always_inline]] void end(std::size_t i, const Sums& sums) const {
    pass().leave(i, sums, OverLanes{});
  }

  template <class Self, class Sums>
  [[gnu::always_inline]] void add(const Self& a, const ReferencePair<double, D>& pair, LatticePlace place,
                                  Sums& sums) const {
    pass().meet(a, {broadcast<Number>(pair.x), pair.h, pair.value, broadcast<Number>(pair.slope)}, place, sums);
  }
  template <class Sums>
  [[gnu::always_inline]] void end(std::size_t i, const Sums& sums, std::size_t lane) const {
    pass().leave(i, sums, OneLane{lane});
  }

 private:
  const Pass& pass() const { return static_cast<const Pass&>(*this); }
};

/// Deformation of Young et al. (2021), eq. 2 and 13: F = I + Σ V_b0 (u_b - u_a) ⊗ ∇̃_0W̃ and its rate. The correction is
/// the same for all terms of the sum, so that it is applied to the whole.
template <class Kernel, int D, bool corrected, class Records>
struct DeformationSums : ReferenceSums<DeformationSums<Kernel, D, corrected, Records>, Kernel, D, Records> {
  StressRecord<D>* deformed;  ///< their cofactor is F from now on, and their stress dF/dt in 1/s

  using Number = typename Records::Number;
  struct Self {
    OwnReference<Records, D> reference;
    Vector<Number, D> x, v;
  };
  /// Σ V f ⊗ ∇W and Σ V f W of f = u or v.
  struct Moments {
    Tensor<Number, D> slope = Tensor<Number, D>::zero();
    Vector<Number, D> value = Vector<Number, D>::zero();
  };
  struct Sums {
    Moments displacement, rate;
  };

  [[gnu::always_inline]] Self begin(const typename Records::Own& i) const {
    const auto& r = this->records;
    return {OwnReference<Records, D>(r, i), own(r.motion, i, &MotionRecord<D>::x),
            own(r.motion, i, &MotionRecord<D>::v)};
  }

  [[gnu::always_inline]] void meet(const Self& a, const ReferencePair<Number, D>& pair, typename Records::Index j,
                                   Sums& sums) const {
    const auto& r = this->records;
    const auto u = gathered(r.motion, j, &MotionRecord<D>::x) - a.x + pair.x;
    const auto v = gathered(r.motion, j, &MotionRecord<D>::v) - a.v;
    const Number volume = gathered(r.reference, j, &ReferenceRecord<D>::volume);
    const auto slope = volume * pair.slope;
    add_outer(sums.displacement.slope, u, slope);
    add_outer(sums.rate.slope, v, slope);
    if constexpr (corrected) {
      const Number value = volume * pair.value;
      sums.displacement.value += value * u;
      sums.rate.value += value * v;
    }
  }

  template <class Lanes>
  [[gnu::always_inline]] void leave(std::size_t i, const Sums& sums, const Lanes& lanes) const {
    auto& f = deformed[i].cofactor;
    f = gradient(i, sums.displacement, lanes);
    for (int k = 0; k < D; ++k) f(k, k) += 1.0;
    deformed[i].stress = gradient(i, sums.rate, lanes);
  }

 private:
  template <class Lanes>
  [[gnu::always_inline]] Tensor<double, D> gradient(std::size_t i, const Moments& moments, const Lanes& lanes) const {
    Tensor<double, D> slope;
    for (int k = 0; k < D * D; ++k) slope.c[k] = lanes.sum(moments.slope.c[k]);
    if constexpr (corrected) {
      const auto& correction = this->corrections[i];
      for (int r = 0; r < D; ++r)
        for (int c = 0; c < D; ++c) slope(r, c) -= lanes.sum(moments.value[r]) * correction.shift[c];
      return product_with_transposed(slope, correction.matrix);
    } else {
      return slope;
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
    : ReferenceSums<LagrangianForces<Kernel, Viscosity, D, corrected, Records>, Kernel, D, Records> {
  Viscosity viscosity;
  const StressRecord<D>* stress;
  const ShiftRecord<D>* shift;  ///< null without a correction
  const double* mass;
  Vector<double, D>* acceleration;
  double* viscous_power;   ///< W/kg
  double* viscous_signal;  ///< m/s

  using Number = typename Records::Number;
  using Stress = StressRecord<D>;
  struct Self {
    OwnReference<Records, D> reference;
    Vector<Number, D> x, v;
    Number density, sound_speed, stretch;
    Tensor<Number, D> cofactor;
    Vector<Number, D> cofactor_shift;
    Vector<Number, StrainRateRecord<D>::components> rate;
  };
  struct Sums {
    Vector<Number, D> slope = Vector<Number, D>::zero();  ///< Σ V_b0 ∇W_ab, by which P_a acts
    Number value = 0.0;                                   ///< Σ V_b0 W_ab
    Vector<Number, D> pull = Vector<Number, D>::zero();
    Vector<Number, D> viscous = Vector<Number, D>::zero();
    Number heat = 0.0;
    Number signal = 0.0;
  };

  [[gnu::always_inline]] Self begin(const typename Records::Own& i) const {
    const auto& r = this->records;
    Self a{OwnReference<Records, D>(r, i),
           own(r.motion, i, &MotionRecord<D>::x),
           own(r.motion, i, &MotionRecord<D>::v),
           own(r.stress, i, &Stress::density),
           own(r.stress, i, &Stress::sound_speed),
           own(r.stress, i, &Stress::least_stretch),
           own(r.stress, i, &Stress::cofactor),
           {},
           {}};
    if constexpr (corrected) a.cofactor_shift = own(r.shift, i, &ShiftRecord<D>::cofactor);
    if constexpr (Viscosity::reconstructs) a.rate = own(r.strain_rate, i, &StrainRateRecord<D>::rate);
    return a;
  }

  [[gnu::always_inline]] void meet(const Self& a, const ReferencePair<Number, D>& pair, typename Records::Index j,
                                   Sums& sums) const {
    const auto& r = this->records;
    const Number volume = gathered(r.reference, j, &ReferenceRecord<D>::volume);
    const auto x = a.x - gathered(r.motion, j, &MotionRecord<D>::x);
    const auto v = a.v - gathered(r.motion, j, &MotionRecord<D>::v);

    // The gradient of the neighbour's kernel is that of -∇W: both signs are turned here.
    auto pull = times(gathered(r.stress, j, &Stress::stress), pair.slope);
    if constexpr (corrected) pull += pair.value * gathered(r.shift, j, &ShiftRecord<D>::stress);
    sums.pull += pull;
    sums.slope += volume * pair.slope;
    if constexpr (corrected) sums.value += volume * pair.value;

    const Number approach = select(volume * pair.value > Number(0.0), dot(v, x), Number(0.0));
    if (any_of(approach < Number(0.0))) damp(a, pair, j, x, v, volume, approach, sums);
  }

  template <class Lanes>
  [[gnu::always_inline]] void leave(std::size_t i, const Sums& sums, const Lanes& lanes) const {
    const auto& self = this->reference[i];
    if (self.lagrangian == 0.0) {
      acceleration[i] = Vector<double, D>::zero();
      viscous_power[i] = viscous_signal[i] = 0.0;
      return;
    }
    const double over_mass = 1.0 / mass[i];
    const double over_jacobian = self.volume * over_mass * stress[i].density;
    Vector<double, D> slope;
    for (int k = 0; k < D; ++k) slope[k] = lanes.sum(sums.slope[k]);
    auto push = times(stress[i].stress, slope);
    if constexpr (corrected) push = push - lanes.sum(sums.value) * shift[i].stress;
    for (int k = 0; k < D; ++k)
      acceleration[i][k] = over_mass * (push[k] + self.volume * lanes.sum(sums.pull[k])) -
                           0.5 * over_jacobian * lanes.sum(sums.viscous[k]) + 0.0;  // of failed ones, zero without sign
    viscous_power[i] = 0.25 * over_jacobian * lanes.sum(sums.heat);
    viscous_signal[i] = lanes.largest(sums.signal) + 0.0;  // or zero had the sign of who stands beside in a pack
  }

 private:
  /// What the viscosity adds to a pair, nothing where it does not approach: most of what a pair costs, and pairs that
  /// part, or rest, do so side by side.
  [[gnu::always_inline]] void damp(const Self& a, const ReferencePair<Number, D>& pair, typename Records::Index j,
                                   const Vector<Number, D>& x, const Vector<Number, D>& v, const Number& volume,
                                   const Number& approach, Sums& sums) const {
    const auto& r = this->records;
    auto bracket = times(gathered(r.stress, j, &Stress::cofactor), pair.slope);
    bracket += times(a.cofactor, pair.slope);
    if constexpr (corrected)
      bracket += pair.value * (gathered(r.shift, j, &ShiftRecord<D>::cofactor) - a.cofactor_shift);
    const Number density = gathered(r.stress, j, &Stress::density);
    const Number c = Number(0.5) * (a.sound_speed + gathered(r.stress, j, &Stress::sound_speed));
    // Of the present configuration, as the places are: with h as it was at the start μ would grow as they come nearer.
    const Number h = pair.h * (Number(0.5) * (a.stretch + gathered(r.stress, j, &Stress::least_stretch)));
    const Number damped = damped_approach<Viscosity>(r.strain_rate, j, a.rate, x, approach);
    const auto [pi, speed] = viscosity(damped, dot(x, x), h, c, Number(0.5) * (a.density + density));
    // Where the deformation turns the gradients against the line between the particles, Π would drive them, not damp
    // them.
    const Number power = dot(v, bracket);
    const Number damping = select(power > Number(0.0), volume * density * pi, Number(0.0));
    sums.viscous += damping * bracket;
    sums.heat += damping * power;
    sums.signal = larger(sums.signal, speed);
  }
};

}  // namespace tektite
