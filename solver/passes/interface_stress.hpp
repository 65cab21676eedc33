#pragma once

#include <cstdint>

#include "core/pack.hpp"
#include "passes/kernel_pair.hpp"
#include "passes/lagrangian_records.hpp"
#include "physics/artificial_stress.hpp"

namespace tektite {

/// What artificial stress needs of a particle.
struct ArtificialStressRecord {
  double r[3];     ///< R: xx, yy, xy in m⁵/(kg s²)
  double spacing;  ///< Δp, m

  void mirror(int, double) { r[2] = -r[2]; }
};

/// Artificial stress of Eulerian particles on total-Lagrangian ones, in the plane. As with viscosity, the gradients of
/// the reference configuration stand for those of the present one: Young et al. (2021), eq. 8 and 9,
///   a_a -= Σ ½ m_b fⁿ (R_b J_a⁻¹ F_b⁻ᵀ ∇̃_b0 W̃_ba - R_a J_b⁻¹ F_a⁻ᵀ ∇̃_a0 W̃_ab),  f = W_ab/W(Δp) at the present places
template <class Kernel>
struct InterfaceStress {
  const ReferenceRecord<2>* reference;
  const MotionRecord<2>* motion;
  const StressRecord<2>* stress;
  const ArtificialStressRecord* artificial;
  ArtificialStress settings;
  const double* mass;
  Vector<double, 2>* acceleration;  ///< is added to
  double* viscous_power;            ///< is added to, W/kg

  struct Self {
    Vector<Pack, 2> reference, x, v;
    Tensor<Pack, 2> cofactor;
    Pack r[3];
    Pack h, lagrangian, spacing;
    Correction<Pack, 2> correction;
  };
  struct Sums {
    Vector<Pack, 2> force = Vector<Pack, 2>::zero();
    Pack heat = 0.0;
  };

  Self begin(std::size_t i) const {
    Self a;
    for (int k = 0; k < 2; ++k) {
      a.reference[k] = reference[i].x[k];
      a.x[k] = motion[i].x[k];
      a.v[k] = motion[i].v[k];
      a.correction.shift[k] = reference[i].correction.shift[k];
    }
    for (int k = 0; k < 4; ++k) {
      a.cofactor.c[k] = stress[i].cofactor.c[k];
      a.correction.matrix.c[k] = reference[i].correction.matrix.c[k];
    }
    for (int k = 0; k < 3; ++k) a.r[k] = artificial[i].r[k];
    a.h = reference[i].smoothing_length;
    a.lagrangian = reference[i].lagrangian;
    a.spacing = artificial[i].spacing;
    return a;
  }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto from = [&](const auto* records, auto member) {
      return Pack([&](auto lane) { return member(records[j[static_cast<std::size_t>(lane)]]); });
    };
    const Pack other_type = from(reference, [](const auto& r) { return r.lagrangian; });
    const auto meets = other_type != a.lagrangian;
    if (std::experimental::none_of(meets)) return;
    Vector<Pack, 2> reference_x, x, v;
    Correction<Pack, 2> correction;
    Tensor<Pack, 2> cofactor;
    for (int k = 0; k < 2; ++k) {
      reference_x[k] = a.reference[k] - from(reference, [k](const auto& r) { return r.x[k]; });
      x[k] = a.x[k] - from(motion, [k](const auto& r) { return r.x[k]; });
      v[k] = a.v[k] - from(motion, [k](const auto& r) { return r.v[k]; });
      correction.shift[k] = from(reference, [k](const auto& r) { return r.correction.shift[k]; });
    }
    for (int k = 0; k < 4; ++k) {
      correction.matrix.c[k] = from(reference, [k](const auto& r) { return r.correction.matrix.c[k]; });
      cofactor.c[k] = from(stress, [k](const auto& r) { return r.cofactor.c[k]; });
    }
    Pack r[3];
    for (int k = 0; k < 3; ++k) r[k] = from(artificial, [k](const auto& record) { return record.r[k]; });
    const Pack h = Pack(0.5) * (a.h + from(reference, [](const auto& record) { return record.smoothing_length; }));
    const KernelPair<Kernel, 2> pair(reference_x, h), now(x, h);
    auto apart = Vector<Pack, 2>::zero();
    apart[0] = Pack(0.5) * (a.spacing + from(artificial, [](const auto& record) { return record.spacing; }));
    const Pack f = now.value / KernelPair<Kernel, 2>(apart, h).value;
    Pack power = f;
    for (int k = 1; k < settings.exponent; ++k) power *= f;

    const auto here = times(a.cofactor, a.correction.gradient(pair.slope, pair.value));
    const auto there = times(cofactor, correction.gradient(Pack(-1.0) * pair.slope, pair.value));
    const Pack push[2] = {a.r[0] * here[0] + a.r[2] * here[1] - r[0] * there[0] - r[2] * there[1],
                          a.r[2] * here[0] + a.r[1] * here[1] - r[2] * there[0] - r[1] * there[1]};
    const Pack volume = from(reference, [](const auto& record) { return record.volume; });
    const Pack density = from(stress, [](const auto& record) { return record.density; });
    const Pack factor = select(meets, volume * density * power, Pack(0.0));
    for (int k = 0; k < 2; ++k) sums.force[k] += factor * push[k];
    sums.heat += factor * (v[0] * push[0] + v[1] * push[1]);
  }

  void end(std::size_t i, const Sums& sums) const {
    if (reference[i].lagrangian == 0.0) return;
    const double over_jacobian = reference[i].volume * stress[i].density / mass[i];
    for (int k = 0; k < 2; ++k) acceleration[i][k] += 0.5 * over_jacobian * sum(sums.force[k]);
    viscous_power[i] -= 0.25 * over_jacobian * sum(sums.heat);
  }
};

}  // namespace tektite
