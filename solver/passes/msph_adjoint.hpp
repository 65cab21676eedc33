#pragma once

#include "passes/msph_sums.hpp"

namespace tektite {

/// Forces as the adjoint of the strain rates: what -Σ_j V_j (σ_j : ∇v_j + s_j v_j), with MSPH's own ∇v_j and v_j, takes
/// for a velocity of particle i, over V_i. So they keep momentum, do the work that heats, and leave a free surface free
/// of traction without being told, where the strong form of Batra and Zhang (2008), eq. 3.1, is exact for smooth
/// stresses but keeps momentum only as far as they are smooth. s is the stress across the space over the radius, whose
/// rate is v/R for each of the `hoops` directions there. N/m³.
template <class Weights, int D, int hoops>
struct MsphAdjoint {
  MsphGather<D> gather;
  const MsphCoefficients<D>* coefficients;  ///< of images too
  const double* across_stress;              ///< Pa, of images too
  Vector<double, D>* force;

  using Self = MsphSelf<D>;
  struct Sums {
    Vector<Pack, D> f = Vector<Pack, D>::zero();
  };
  Self begin(std::size_t i) const { return gather.self(i); }
  bool far(const Self& a, const std::uint32_t* j) const { return gather.far(a, j); }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto& own = gather.records[a.i];
    const auto p = gather.pair(a, j);
    const MsphShape<Weights, D> psi(coefficients[a.i], own.volume, p, a.over_h);

    const Pack over_h = Pack(1.0) / gather.read(j, [](const auto& q) -> const double& { return q.smoothing_length; });
    const Vector<Pack, D> xi = (Pack(-own.smoothing_length) * over_h) * p.xi;
    const auto near = p.other && dot(xi, xi) < Pack(MsphGather<D>::support * MsphGather<D>::support);
    const auto phi = Weights::at(xi);
    const auto row = [&](int r) {
      Pack s = 0.0;
      for (int k = 0; k < taylor_terms<D>; ++k)
        s += phi[k] * Pack([&](auto lane) { return coefficients[j[static_cast<std::size_t>(lane)]].row[r][k]; });
      return select(near, s, Pack(0.0));
    };

    for (int c = 0; c < D; ++c) {
      const Pack slope = row(c + 1) * over_h;
      for (int r = 0; r < D; ++r) {
        const int k = EulerianRecord<D>::index(r, c);
        sums.f[r] += Pack(own.stress[k]) * psi.slope[c] -
                     gather.read(j, [k](const auto& q) -> const double& { return q.stress[k]; }) * slope;
      }
    }
    if constexpr (hoops > 0) {
      const Pack s([&](auto lane) { return over_radius(j[static_cast<std::size_t>(lane)]); });
      sums.f[0] += Pack(over_radius(a.i)) * psi.value - s * row(0);
    }
  }

  void end(std::size_t i, const Sums& sums) const {
    for (int k = 0; k < D; ++k) force[i][k] = sum(sums.f[k]);
    if constexpr (hoops > 0) force[i][0] -= over_radius(i);
  }

 private:
  /// s; on the axis, where the rate is the gradient's ∂v_R/∂R, the stress across is part of σ_RR instead.
  double over_radius(std::size_t i) const {
    const double radius = gather.records[i].x[0];
    return radius == 0.0 ? 0.0 : hoops * across_stress[i] / radius;
  }
};

}  // namespace tektite
