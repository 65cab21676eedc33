#pragma once

#include <cstdint>
#include <limits>

#include "passes/far.hpp"
#include "passes/godunov_records.hpp"
#include "passes/pair_gradients.hpp"
#include "physics/riemann/wave.hpp"

namespace tektite {

/// No limiter: the state of a side is that of its particle (first order).
struct NoReconstruction {};

/// The hydrodynamic half of the time-split Godunov paper's eq. 21, 22 and 34, with one Riemann problem a pair along
/// e_ij, which points from j, the left side, to i, the right one; v* is counted from ṽ_i here:
///   dv̌/dt = -(2/ρ_i) Σ V_j p* ∇W
///   power = -(2/ρ_i) Σ V_j p* v* e·∇W                 (eq. 34; AdvanceHydrodynamic adds its time-centred part)
///   tr L* = 2 Σ V_j v* e·∇W                           dρ/dt = -ρ tr L*, the sign of eq. 22 corrected: as printed,
///                                                     compression would lower the density
///   L     = Σ V_j (ṽ_j - ṽ_i) ⊗ ∇W                   what shears the deviatoric stress
/// Second order reconstructs both sides by eq. 23-27 with the domain of influence (1 - c Δt/r_ij) (printed without
/// r_ij); Algorithm 1 leaves that out where either particle has failed, and lets such a pair bear no tension.
///
/// With corrected gradients the pressures of both act with the gradients of each, as in the deviatoric half, and what
/// the waves add, π = p* - ½ (p_i + p_j) and w, the speed of the contact beyond the mean of both, acts along e_ij with
/// their mean, g = ½ e·(∇̃_iW̃_ij - ∇̃_jW̃_ji), never above zero, so that it damps:
///   dv̌/dt = -(1/ρ_i) Σ V_j (p_i ∇̃_iW̃_ij - p_j ∇̃_jW̃_ji + 2 π g e)
///   tr L* = Σ V_j ((ṽ_j - ṽ_i)·∇̃_iW̃_ij + 2 w g)      exact for linear fields
///   power = -(1/ρ_i) Σ V_j (p_i (ṽ_j - ṽ_i)·∇̃_iW̃_ij + (p_i + p_j) w g + 2 π v* g)
/// whose sum over a pair is the work of its forces. In a pair with a failed particle p_i and p_j are not below zero.
/// In second order p_i and p_j are those of the end of the step, p - Δt ρ c² tr L with L of ṽ, and the velocities those
/// of its start: pressures change by ṽ and velocities by these pressures, with sums that are each other's adjoint, as
/// in a leapfrog, so that no motion grows by the step, up to free surfaces. The domain of influence sees e·L e, which
/// is not zero in shear, as a viscosity would; the middle of the step for both, with v - ½ Δt ∇p/ρ, misses what a free
/// surface accelerates, where an even pressure has no gradient.
template <class Kernel, class Smoothing, int D, class Solver, class Limiter, class Gradients = PlainGradients<D>>
struct HydrodynamicRates {
  using Record = HydrodynamicRecord<D>;
  static constexpr bool reconstructs = !std::is_same_v<Limiter, NoReconstruction>;
  static constexpr std::size_t numbers = Record::plain + (reconstructs ? 2 * D + D * D : 0);

  const Record* records;
  Smoothing smoothing;
  Solver solver;
  Limiter limiter;
  double step;
  Vector<double, D>* acceleration;
  double* power;       ///< W/kg
  double* divergence;  ///< tr L*, 1/s
  Tensor<double, D>* velocity_gradient;
  double* approach;  ///< largest speed at which a neighbour comes nearer, m/s
  Gradients gradients = {};

  struct Self {
    Vector<Pack, D> x, v;
    Pack density, pressure, sound_speed, shock_slope, inverse_slope, h, failed;
    Vector<Pack, D> density_gradient, pressure_gradient;
    Tensor<Pack, D> velocity_gradient;
    typename Gradients::Self gradients;
  };
  struct Sums {
    Vector<Pack, D> force = Vector<Pack, D>::zero();
    Pack power = 0.0;
    Pack divergence = 0.0;
    Tensor<Pack, D> gradient = Tensor<Pack, D>::zero();
    Pack approach = 0.0;
  };

  Self begin(std::size_t i) const {
    const Record& r = records[i];
    Self a;
    a.x = broadcast(r.x);
    a.v = broadcast(r.v);
    a.density = r.density;
    a.pressure = r.pressure;
    a.sound_speed = r.sound_speed;
    a.shock_slope = r.shock_slope;
    a.inverse_slope = r.inverse_slope;
    a.h = r.smoothing_length;
    a.failed = r.failed;
    a.gradients = gradients.begin(i);
    if constexpr (reconstructs) {
      a.density_gradient = broadcast(r.density_gradient);
      a.pressure_gradient = broadcast(r.pressure_gradient);
      a.velocity_gradient = broadcast(r.velocity_gradient);
    }
    return a;
  }

  bool far(const Self& a, const std::uint32_t* j) const { return all_far<Kernel>(a, records, j, smoothing); }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto other = gather_records<numbers>(records, j);
    const Pack* const b = other.number;
    const Pack* const rest = b + 2 * D;  // density, pressure, sound speed, A, 1/A, volume, h, failed
    Vector<Pack, D> x, v;                // x_ij and ṽ_j - ṽ_i
    for (int k = 0; k < D; ++k) {
      x[k] = a.x[k] - b[k];
      v[k] = b[D + k] - a.v[k];
    }
    const Pack h = smoothing.of_pair(a.h, rest[6]);
    const PairAxis<Kernel, D> pair(x, smoothing.inverse_of(h));
    const Pack closing = dot(v, pair.e);
    RiemannSide<Pack> right{a.pressure, Pack(0.0), a.density, a.sound_speed, a.shock_slope, a.inverse_slope};
    RiemannSide<Pack> left{rest[1], closing, rest[0], rest[2], rest[3], rest[4]};
    const auto failed = a.failed + rest[7] > Pack(0.0);
    Pack own_pressure = a.pressure, other_pressure = rest[1];  // which act with the gradients of each
    if constexpr (reconstructs) {
      const Pack intact = select(failed, Pack(0.0), Pack(0.5)), time = Pack(step);
      const Pack* const slopes = b + Record::plain;
      if constexpr (Gradients::corrected) {
        const Pack whole_step = select(failed, Pack(0.0), time);
        own_pressure = advance(right, a.velocity_gradient.c, whole_step);
        other_pressure = advance(left, slopes + 2 * D, whole_step);
        reconstruct(a, slopes, pair.e, intact * pair.distance, intact * pair.distance, left, right);
      } else {
        reconstruct(a, slopes, pair.e, intact * larger(pair.distance - time * left.sound_speed, Pack(0.0)),
                    intact * larger(pair.distance - time * right.sound_speed, Pack(0.0)), left, right);
      }
    }
    auto star = solver(left, right);
    star.pressure = select(failed, larger(star.pressure, Pack(0.0)), star.pressure);

    if constexpr (Gradients::corrected) {
      const auto least = select(failed, Pack(0.0), Pack(-std::numeric_limits<double>::infinity()));
      add_corrected(rest[5], gradients.of_pair(a.gradients, j, x, h), pair.e, v, closing, larger(own_pressure, least),
                    larger(other_pressure, least), star, sums);
    } else {
      add_plain(rest[5] * pair.slope, pair.e, v, star, sums);
    }
    sums.approach = larger(sums.approach, select(pair.slope < Pack(0.0), closing, Pack(0.0)));
  }

  void end(std::size_t i, const Sums& sums) const {
    const double twice = -2.0 / records[i].density;
    for (int k = 0; k < D; ++k) acceleration[i][k] = twice * sum(sums.force[k]);
    power[i] = twice * sum(sums.power);
    divergence[i] = 2.0 * sum(sums.divergence);
    for (int k = 0; k < D * D; ++k) velocity_gradient[i].c[k] = sum(sums.gradient.c[k]);
    approach[i] = largest(sums.approach);
  }

 private:
  /// `weight` is V_j e·∇W.
  static void add_plain(const Pack& weight, const Vector<Pack, D>& e, const Vector<Pack, D>& v,
                        const RiemannStar<Pack>& star, Sums& sums) {
    const Pack push = weight * star.pressure;
    for (int i = 0; i < D; ++i) {
      sums.force[i] += push * e[i];
      const Pack across = weight * v[i];
      for (int k = 0; k < D; ++k) sums.gradient(i, k) += across * e[k];
    }
    sums.power += push * star.velocity;
    sums.divergence += weight * star.velocity;
  }

  template <class Pair>
  static void add_corrected(const Pack& volume, const Pair& pair, const Vector<Pack, D>& e, const Vector<Pack, D>& v,
                            const Pack& closing, const Pack& own_pressure, const Pack& other_pressure,
                            const RiemannStar<Pack>& star, Sums& sums) {
    const Pack mean_pressure = Pack(0.5) * (own_pressure + other_pressure);
    const Pack g = smaller(Pack(0.5) * dot(e, pair.own - pair.other), Pack(0.0));
    const Pack damping = (star.pressure - mean_pressure) * g;
    const Pack strain = Pack(0.5) * dot(v, pair.own), beyond = (star.velocity - Pack(0.5) * closing) * g;
    for (int i = 0; i < D; ++i) {
      const Pack push = Pack(0.5) * (own_pressure * pair.own[i] - other_pressure * pair.other[i]) + damping * e[i];
      sums.force[i] += volume * push;
      const Pack across = volume * v[i];
      for (int k = 0; k < D; ++k) sums.gradient(i, k) += across * pair.own[k];
    }
    sums.power += volume * (own_pressure * strain + mean_pressure * beyond + damping * star.velocity);
    sums.divergence += volume * (strain + beyond);
  }

  /// Brings pressure and density of a side to the end of the step with its own gradient of the velocity; the pressure
  /// there.
  static Pack advance(RiemannSide<Pack>& side, const Pack* slopes_of_velocity, const Pack& whole_step) {
    Pack expansion = slopes_of_velocity[0];
    for (int k = 1; k < D; ++k) expansion += slopes_of_velocity[k * D + k];
    const Pack thinning = whole_step * expansion * side.density;
    side.density -= thinning;
    side.pressure -= thinning * side.sound_speed * side.sound_speed;
    return side.pressure;
  }

  /// Brings both sides to the middle of the pair with their limited slopes; `slopes` are the left particle's.
  void reconstruct(const Self& a, const Pack* slopes, const Vector<Pack, D>& e, const Pack& left_way,
                   const Pack& right_way, RiemannSide<Pack>& left, RiemannSide<Pack>& right) const {
    const auto along = [&](const Pack* gradient) {
      Pack slope = gradient[0] * e[0];
      for (int k = 1; k < D; ++k) slope += gradient[k] * e[k];
      return slope;
    };
    const auto bend = [&](Pack RiemannSide<Pack>::*member, const Pack& left_slope, const Pack& right_slope) {
      const Pack slope = limiter(left_slope, right_slope);
      left.*member += left_way * slope;
      right.*member -= right_way * slope;
    };
    bend(&RiemannSide<Pack>::density, along(slopes), along(a.density_gradient.c));
    bend(&RiemannSide<Pack>::pressure, along(slopes + D), along(a.pressure_gradient.c));
    Pack left_slope = 0.0, right_slope = 0.0;  // of the velocity along e
    for (int k = 0; k < D; ++k) {
      left_slope += e[k] * along(slopes + 2 * D + k * D);
      right_slope += e[k] * along(a.velocity_gradient.c + k * D);
    }
    bend(&RiemannSide<Pack>::velocity, left_slope, right_slope);
  }
};

}  // namespace tektite
