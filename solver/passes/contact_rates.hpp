#pragma once

#include <cstdint>

#include "passes/far.hpp"
#include "passes/godunov_records.hpp"

namespace tektite {

/// The contacts of Parshikov and Medin (2002) with the full stress vector in every space: the time-split Godunov paper,
/// eq. 15 and 16. The traction σ e on the plane between two particles has a part along e_ij, carried by longitudinal
/// waves, and one across it, carried by transverse ones; e_ij points from j, the left side, to i, the right one, for
/// which the signs of eq. 15 are
///   v* = (z_i v_i + z_j v_j + σ_i - σ_j)/(z_i + z_j),  σ* = (z_i σ_j + z_j σ_i + z_i z_j (v_i - v_j))/(z_i + z_j).
/// With v* counted from v_i:
///   dv/dt = (2/ρ_i) Σ V_j σ* e·∇W,  power = (2/ρ_i) Σ V_j σ*·v* e·∇W,  L = 2 Σ V_j v* ⊗ ∇W,
/// and dρ/dt = -ρ tr L, the sign of eq. 16 corrected.
///
/// Where a side has failed, the contact bears no tension, and no waves of shear: across e_ij it moves with the mean
/// velocity of both and bears, under pressure, what failed material bears by itself, which is friction in a ceramic and
/// nothing elsewhere.
template <class Kernel, class Smoothing, int D>
struct ContactRates {
  using Record = ContactStateRecord<D>;

  const Record* records;
  Smoothing smoothing;
  const double* density;
  Vector<double, D>* acceleration;
  double* power;       ///< W/kg
  double* divergence;  ///< tr L, 1/s
  Tensor<double, D>* velocity_gradient;
  double* approach;  ///< largest speed at which a neighbour comes nearer, m/s

  struct Self {
    Vector<Pack, D> x, v;
    Pack stress[Record::stresses];
    Pack longitudinal, transverse, h, failed;
  };
  struct Sums {
    Vector<Pack, D> force = Vector<Pack, D>::zero();
    Pack power = 0.0;
    Tensor<Pack, D> gradient = Tensor<Pack, D>::zero();
    Pack approach = 0.0;
  };

  Self begin(std::size_t i) const {
    const Record& r = records[i];
    Self a;
    a.x = broadcast(r.x);
    a.v = broadcast(r.v);
    broadcast(r.stress, a.stress);
    a.longitudinal = r.longitudinal;
    a.transverse = r.transverse;
    a.h = r.smoothing_length;
    a.failed = r.failed;
    return a;
  }

  bool far(const Self& a, const std::uint32_t* j) const { return all_far<Kernel>(a, records, j, smoothing); }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto other = gather_records<2 * D + Record::stresses + 5>(records, j);
    const Pack* const b = other.number;
    const Pack* const other_stress = b + 2 * D;
    const Pack* const rest = other_stress + Record::stresses;  // volume, z_l, z_t, h, failed
    Vector<Pack, D> x, v;                                      // x_ij and v_j - v_i
    for (int k = 0; k < D; ++k) {
      x[k] = a.x[k] - b[k];
      v[k] = b[D + k] - a.v[k];
    }
    const PairAxis<Kernel, D> pair(x, smoothing.inverse_of(smoothing.of_pair(a.h, rest[3])));
    Vector<Pack, D> own, others;  // tractions
    for (int i = 0; i < D; ++i) {
      own[i] = a.stress[Record::index(i, 0)] * pair.e[0];
      others[i] = other_stress[Record::index(i, 0)] * pair.e[0];
      for (int k = 1; k < D; ++k) {
        own[i] += a.stress[Record::index(i, k)] * pair.e[k];
        others[i] += other_stress[Record::index(i, k)] * pair.e[k];
      }
    }
    const Pack closing = dot(v, pair.e), own_normal = dot(own, pair.e), other_normal = dot(others, pair.e);
    const Wave along(a.longitudinal, rest[1]), across(a.transverse, rest[2]);
    const Friction friction(a.failed, rest[4]);
    const Pack normal_stress = friction.normal(along.stress(own_normal, other_normal, closing));
    const Pack normal_velocity = along.velocity(own_normal, other_normal, closing);
    const Pack weight = rest[0] * pair.slope;  // V_j e·∇W
    for (int i = 0; i < D; ++i) {
      const Pack own_part = own[i] - own_normal * pair.e[i], other_part = others[i] - other_normal * pair.e[i];
      const Pack slide = v[i] - closing * pair.e[i];
      const Pack shear =
          friction.shear(own_part, other_part, normal_stress, across.stress(own_part, other_part, slide));
      const Pack stress = normal_stress * pair.e[i] + shear;
      const Pack velocity =
          normal_velocity * pair.e[i] + friction.velocity(slide, across.velocity(own_part, other_part, slide));
      sums.force[i] += weight * stress;
      sums.power += weight * stress * velocity;
      for (int k = 0; k < D; ++k) sums.gradient(i, k) += weight * velocity * pair.e[k];
    }
    sums.approach = larger(sums.approach, select(pair.slope < Pack(0.0), closing, Pack(0.0)));
  }

  void end(std::size_t i, const Sums& sums) const {
    const double twice = 2.0 / density[i];
    for (int k = 0; k < D; ++k) acceleration[i][k] = twice * sum(sums.force[k]);
    power[i] = twice * sum(sums.power);
    for (int k = 0; k < D * D; ++k) velocity_gradient[i].c[k] = 2.0 * sum(sums.gradient.c[k]);
    divergence[i] = trace(velocity_gradient[i]);
    approach[i] = largest(sums.approach);
  }

 private:
  /// Two waves of one kind that leave a contact, by the impedances of its sides. Where neither side carries them there
  /// is no stress, and the contact moves as particle i does.
  struct Wave {
    Pack own, other, inverse;

    Wave(const Pack& zi, const Pack& zj) : own(zi), other(zj) {
      const auto carried = zi + zj > Pack(0.0);
      inverse = select(carried, Pack(1.0) / select(carried, zi + zj, Pack(1.0)), Pack(0.0));
    }
    Pack stress(const Pack& si, const Pack& sj, const Pack& closing) const {
      return (own * sj + other * si - own * other * closing) * inverse;
    }
    Pack velocity(const Pack& si, const Pack& sj, const Pack& closing) const {
      return (other * closing + si - sj) * inverse;
    }
  };

  /// What becomes of a contact where a side has failed.
  struct Friction {
    Pack own, other;  ///< the parts that the tractions of both have in it
    Pack::mask_type failed;

    Friction(const Pack& failed_i, const Pack& failed_j) : failed(failed_i + failed_j > Pack(0.0)) {
      const Pack part = Pack(1.0) / larger(failed_i + failed_j, Pack(1.0));
      own = failed_i * part;
      other = failed_j * part;
    }
    Pack normal(const Pack& stress) const { return select(failed, smaller(stress, Pack(0.0)), stress); }
    Pack shear(const Pack& si, const Pack& sj, const Pack& normal, const Pack& intact) const {
      return select(failed, select(normal < Pack(0.0), own * si + other * sj, Pack(0.0)), intact);
    }
    Pack velocity(const Pack& slide, const Pack& intact) const { return select(failed, Pack(0.5) * slide, intact); }
  };
};

}  // namespace tektite
