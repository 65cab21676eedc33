#pragma once
// Control of zero-energy modes (hourglass modes) of kernels of the reference configuration: a penalty on what the
// places of neighbours differ from a linear motion, after Ganzenmüller (2015), eq. 18-22. With Ξ = X_b - X_a and
// u = u_b - u_a a particle and its neighbours store
//   Φ_a = ½ V_a0 k_a Σ V_b0 ω_ab |e_ab|²,  e_ab = G_a Ξ - u,  ω = -W'/r
// There the error stands along the present bond and is that of the scheme's own F. Here G is the gradient that makes
// Φ_a least, G_a = (Σ V_b0 ω u ⊗ Ξ)(Σ V_b0 ω Ξ ⊗ Ξ)⁻¹: so that forces are exact derivatives of Φ although G is held in
// them, and linear motions store nothing, at surfaces too. Φ does not change with rotations, so angular momentum is
// kept as well. ω makes Σ V ω Ξ ⊗ Ξ the unit tensor inside a body, and k comparable to a modulus.

#include "passes/lagrangian_sums.hpp"

namespace tektite {

/// G of every particle, times its k; without either where its neighbours do not span the space.
template <class Kernel, int D, class Records>
struct FitMotion : ReferenceSums<FitMotion<Kernel, D, Records>, Kernel, D, Records> {
  const double* stiffness;  ///< k, Pa
  HourglassRecord<D>* fits;

  using Number = typename Records::Number;
  struct Self {
    OwnReference<Records, D> reference;
    Vector<Number, D> x;
  };
  struct Sums {
    Tensor<Number, D> motion = Tensor<Number, D>::zero();  ///< Σ V ω u ⊗ Ξ
    Tensor<Number, D> moment = Tensor<Number, D>::zero();  ///< -Σ V ω Ξ ⊗ Ξ
  };

  [[gnu::always_inline]] Self begin(const typename Records::Own& i) const {
    return {OwnReference<Records, D>(this->records, i), own(this->records.motion, i, &MotionRecord<D>::x)};
  }

  [[gnu::always_inline]] void meet(const Self& a, const ReferencePair<Number, D>& pair, typename Records::Index j,
                                   Sums& sums) const {
    const auto& r = this->records;
    const auto u = gathered(r.motion, j, &MotionRecord<D>::x) - a.x + pair.x;
    const auto slope = gathered(r.reference, j, &ReferenceRecord<D>::volume) * pair.slope;  // V ω Ξ
    add_outer(sums.motion, u, slope);
    add_outer(sums.moment, pair.x, slope);
  }

  template <class Lanes>
  [[gnu::always_inline]] void leave(std::size_t i, const Sums& sums, const Lanes& lanes) const {
    Tensor<double, D> motion, moment;
    for (int k = 0; k < D * D; ++k) {
      motion.c[k] = lanes.sum(sums.motion.c[k]);
      moment.c[k] = -lanes.sum(sums.moment.c[k]);
    }
    double scale = 1.0;
    for (int k = 0; k < D; ++k) scale *= trace(moment) / D;
    const double spanned = determinant(moment);
    if (!(spanned > flat * scale)) {
      fits[i] = {0.0, Tensor<double, D>::zero()};
      return;
    }
    fits[i].stiffness = stiffness[i];
    fits[i].gradient = product_with_transposed(motion, cofactor(moment));  // the inverse of a symmetric tensor is C/det
    for (auto& component : fits[i].gradient.c) component *= stiffness[i] / spanned;
  }

 private:
  static constexpr double flat = 1e-3;  ///< of the determinant that the same trace has in all directions alike
};

/// Adds -∂Φ/∂x_a to m_a times the acceleration, with the power that it takes:
///   F_a = -V_a0 Σ V_b0 ω ((k_a G_a + k_b G_b) Ξ - (k_a + k_b) u)
template <class Kernel, int D, class Records>
struct HourglassForces : ReferenceSums<HourglassForces<Kernel, D, Records>, Kernel, D, Records> {
  const HourglassRecord<D>* fits;
  const MotionRecord<D>* motion;
  const double* mass;
  Vector<double, D>* acceleration;
  double* power;  ///< that the particle puts into Φ, W

  using Number = typename Records::Number;
  struct Self {
    OwnReference<Records, D> reference;
    Vector<Number, D> x;
    Number stiffness;
  };
  struct Sums {
    Vector<Number, D> slope = Vector<Number, D>::zero();  ///< Σ V_b0 ω Ξ, by which G_a acts
    Vector<Number, D> pull = Vector<Number, D>::zero();
  };

  [[gnu::always_inline]] Self begin(const typename Records::Own& i) const {
    const auto& r = this->records;
    return {OwnReference<Records, D>(r, i), own(r.motion, i, &MotionRecord<D>::x),
            own(r.hourglass, i, &HourglassRecord<D>::stiffness)};
  }

  [[gnu::always_inline]] void meet(const Self& a, const ReferencePair<Number, D>& pair, typename Records::Index j,
                                   Sums& sums) const {
    const auto& r = this->records;
    const auto u = gathered(r.motion, j, &MotionRecord<D>::x) - a.x + pair.x;
    const Number volume = gathered(r.reference, j, &ReferenceRecord<D>::volume);
    const Number both = a.stiffness + gathered(r.hourglass, j, &HourglassRecord<D>::stiffness);
    // Where two stand in one place, as on a symmetry plane, the slope is zero too.
    const Number weight = dot(pair.slope, pair.x) / larger(dot(pair.x, pair.x), Number(1e-300));  // -ω
    sums.slope += volume * pair.slope;
    sums.pull +=
        volume * (times(gathered(r.hourglass, j, &HourglassRecord<D>::gradient), pair.slope) + (both * weight) * u);
  }

  template <class Lanes>
  [[gnu::always_inline]] void leave(std::size_t i, const Sums& sums, const Lanes& lanes) const {
    Vector<double, D> slope, force;
    for (int k = 0; k < D; ++k) slope[k] = lanes.sum(sums.slope[k]);
    const auto own_part = times(fits[i].gradient, slope);
    for (int k = 0; k < D; ++k) force[k] = -this->reference[i].volume * (own_part[k] + lanes.sum(sums.pull[k]));
    acceleration[i] += (1.0 / mass[i]) * force;
    power[i] = -dot(force, motion[i].v);
  }
};

}  // namespace tektite
