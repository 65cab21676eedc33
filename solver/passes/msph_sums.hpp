#pragma once
// The sums over neighbours of MSPH, in gather form. Derivatives of a particle take its own smoothing length; what two
// particles give each other takes the mean of both.

#include <cstdint>

#include "passes/eulerian_record.hpp"
#include "passes/gathered.hpp"
#include "passes/kernel_pair.hpp"
#include "passes/msph_basis.hpp"

namespace tektite {

/// Four neighbours as a particle sees them: ξ = (x_j - x_i)/h_i, and V_j = m_j/ρ_j where they are within the support
/// and not the particle itself, which fills a list up. The image of a particle on a symmetry plane is a neighbour of
/// it, in its own place and with the other half of its mass.
template <int D>
struct MsphPair {
  Vector<Pack, D> xi;
  Pack volume;
  Pack distance_squared;
  Pack::mask_type other;  ///< not the particle itself
};

template <int D>
struct MsphSelf {
  std::size_t i;
  Vector<Pack, D> x;
  Pack over_h;
};

template <int D>
struct MsphGather {
  static constexpr double support = 2.0;  // of every kernel here
  const EulerianRecord<D>* records;

  template <class Member>
  Pack read(const std::uint32_t* j, const Member& member) const {
    return gathered_by(records, j, member);
  }
  MsphSelf<D> self(std::size_t i) const {
    return {i, broadcast(records[i].x), Pack(1.0 / records[i].smoothing_length)};
  }
  MsphPair<D> pair(const MsphSelf<D>& a, const std::uint32_t* j) const {
    MsphPair<D> p;
    for (int k = 0; k < D; ++k)
      p.xi[k] = (read(j, [k](const auto& r) -> const double& { return r.x[k]; }) - a.x[k]) * a.over_h;
    p.distance_squared = dot(p.xi, p.xi);
    p.other = is_other(a.i, j);
    const auto near = p.other && p.distance_squared < Pack(support * support);
    p.volume = select(near, read(j, [](const auto& r) -> const double& { return r.volume; }), Pack(0.0));
    return p;
  }
  /// Whether no neighbour in j is within the support of the larger smoothing length of both. Lists end with packs that
  /// hold the skin alone.
  bool far(const MsphSelf<D>& a, const std::uint32_t* j) const {
    Vector<Pack, D> x;
    for (int k = 0; k < D; ++k) x[k] = read(j, [k](const auto& r) -> const double& { return r.x[k]; }) - a.x[k];
    const Pack own(records[a.i].smoothing_length);
    const Pack other = read(j, [](const auto& r) -> const double& { return r.smoothing_length; });
    return beyond_support<TruncatedGaussian>(x, larger(own, other), is_other(a.i, j));
  }
  Pack mass(const std::uint32_t* j) const {
    return read(j, [](const auto& r) -> const double& { return r.volume; }) *
           read(j, [](const auto& r) -> const double& { return r.density; });
  }
  /// The kernel, without its constant, with the mean of both smoothing lengths, so that both of a pair have the same.
  template <class Kernel>
  Pack mutual_kernel(const MsphSelf<D>& a, const std::uint32_t* j, const MsphPair<D>& p) const {
    using std::experimental::sqrt;
    const Pack own(records[a.i].smoothing_length);
    const Pack to_mean =
        Pack(2.0) * own / (own + read(j, [](const auto& r) -> const double& { return r.smoothing_length; }));
    const auto near = p.other && to_mean * to_mean * p.distance_squared < Pack(support * support);
    return select(near, Kernel::shape(to_mean * sqrt(p.distance_squared)), Pack(0.0));
  }
};

/// B of Batra and Zhang (2008), eq. 2.3-2.4, inverted; the sum Σ m_j w_ij that conservative smoothing is normalised
/// with; and the mean place of the neighbours, in h, by which surfaces are found: weighted by their volume, or by the
/// section of their ring or shell, so that compression does not look like a surface.
template <class Weights, class Kernel, int D, int hoops>
struct MsphMoments {
  static constexpr int N = taylor_terms<D>;
  MsphGather<D> gather;
  MsphCoefficients<D>* coefficients;
  double* kernel_mass;
  Vector<double, D>* lopsidedness;

  using Self = MsphSelf<D>;
  struct Sums {
    Pack b[N * N] = {};
    Pack mass = 0.0, weight = 0.0;
    Vector<Pack, D> place = Vector<Pack, D>::zero();
  };

  Self begin(std::size_t i) const { return gather.self(i); }
  bool far(const Self& a, const std::uint32_t* j) const { return gather.far(a, j); }

  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    using std::experimental::sqrt;
    const auto p = gather.pair(a, j);
    const auto theta = taylor(p.xi), phi = Weights::at(p.xi);
    for (int r = 0; r < N; ++r) {
      const Pack weighted = p.volume * phi[r];
      for (int c = 0; c < N; ++c) sums.b[r * N + c] += weighted * theta[c];
    }
    sums.mass += gather.template mutual_kernel<Kernel>(a, j, p) * gather.read(j, [](const auto& r) -> const double& {
      return r.volume;
    }) * gather.read(j, [](const auto& r) -> const double& { return r.density; });
    const Pack w = select(p.volume > Pack(0.0), Kernel::shape(sqrt(p.distance_squared)), Pack(0.0));
    const Pack section =
        w * p.volume * section_part(gather.read(j, [](const auto& r) -> const double& { return r.x[0]; }), a.over_h);
    sums.weight += section;
    for (int k = 0; k < D; ++k) sums.place[k] += section * p.xi[k];
  }

  /// Section over volume, without the factor π. A particle on the axis has its mass at a quarter of the spacing, which
  /// is taken for h/6.
  static Pack section_part(const Pack& x, const Pack& over_h) {
    Pack part = 1.0;
    const Pack radius = larger(larger(x, -x), Pack(1.0 / 6.0) / over_h);
    for (int k = 0; k < hoops; ++k) part /= radius;
    return part;
  }

  void end(std::size_t i, const Sums& sums) const {
    const auto& r = gather.records[i];
    Eigen::Matrix<double, N, N> b;
    for (int k = 0; k < N; ++k)
      for (int c = 0; c < N; ++c) b(k, c) = sum(sums.b[k * N + c]) / r.volume;
    const auto own = Weights::at(Vector<double, D>::zero());
    for (int k = 0; k < N; ++k) b(k, 0) += own[k];
    coefficients[i] = invert_moments<D>(b);
    kernel_mass[i] = sum(sums.mass) + Kernel::shape(0.0) * r.volume * r.density;
    const double own_section =
        Kernel::shape(0.0) * r.volume * section_part(Pack(r.x[0]), Pack(1.0 / r.smoothing_length))[0];
    for (int k = 0; k < D; ++k) lopsidedness[i][k] = sum(sums.place[k]) / (sum(sums.weight) + own_section);
  }
};

/// Σ_I B⁻¹_rI Φ_I V_j/V_i of the function (r = 0) and its first derivatives, in 1 and 1/m.
template <class Weights, int D>
struct MsphShape {
  Pack value;
  Vector<Pack, D> slope;

  MsphShape(const MsphCoefficients<D>& c, double own_volume, const MsphPair<D>& p, const Pack& over_h) {
    const auto phi = Weights::at(p.xi);
    const Pack volume = p.volume * Pack(1.0 / own_volume);
    const auto row = [&](int r) {
      Pack s = Pack(c.row[r][0]) * phi[0];
      for (int k = 1; k < taylor_terms<D>; ++k) s += Pack(c.row[r][k]) * phi[k];
      return s * volume;
    };
    value = row(0);
    for (int k = 0; k < D; ++k) slope[k] = row(k + 1) * over_h;
  }
};

/// ∂σ_ab/∂x_b within the space, and of it the part ∂σ_a0/∂x_0 of the last coordinate a, for the limit on the axis;
/// Pa/m.
template <class Weights, int D>
struct MsphDivergence {
  MsphGather<D> gather;
  const MsphCoefficients<D>* coefficients;
  Vector<double, D>* divergence;
  double* radial_part;

  using Self = MsphSelf<D>;
  struct Sums {
    Vector<Pack, D> d = Vector<Pack, D>::zero();
    Pack radial = 0.0;
  };
  Self begin(std::size_t i) const { return gather.self(i); }
  bool far(const Self& a, const std::uint32_t* j) const { return gather.far(a, j); }
  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto& own = gather.records[a.i];
    const MsphShape<Weights, D> psi(coefficients[a.i], own.volume, gather.pair(a, j), a.over_h);
    for (int r = 0; r < D; ++r)
      for (int c = 0; c < D; ++c) {
        const int k = EulerianRecord<D>::index(r, c);
        const Pack part = psi.slope[c] * (gather.read(j, [k](const auto& q) -> const double& { return q.stress[k]; }) -
                                          Pack(own.stress[k]));
        sums.d[r] += part;
        if (r == D - 1 && c == 0) sums.radial += part;
      }
  }
  void end(std::size_t i, const Sums& sums) const {
    for (int k = 0; k < D; ++k) divergence[i][k] = sum(sums.d[k]);
    radial_part[i] = sum(sums.radial);
  }
};

/// The velocity's gradient L and MSPH's own value of it, which carries the particles: in a converging flow one particle
/// may be far from what its neighbourhood does, and would be carried through the axis by its own velocity.
template <class Weights, int D>
struct MsphVelocity {
  MsphGather<D> gather;
  const MsphCoefficients<D>* coefficients;
  Tensor<double, D>* gradient;
  Vector<double, D>* fitted;

  using Self = MsphSelf<D>;
  struct Sums {
    Tensor<Pack, D> l = Tensor<Pack, D>::zero();
    Vector<Pack, D> v = Vector<Pack, D>::zero();
  };
  Self begin(std::size_t i) const { return gather.self(i); }
  bool far(const Self& a, const std::uint32_t* j) const { return gather.far(a, j); }
  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto& own = gather.records[a.i];
    const MsphShape<Weights, D> psi(coefficients[a.i], own.volume, gather.pair(a, j), a.over_h);
    Vector<Pack, D> dv;
    for (int k = 0; k < D; ++k) {
      dv[k] = gather.read(j, [k](const auto& q) -> const double& { return q.v[k]; }) - Pack(own.v[k]);
      sums.v[k] += psi.value * dv[k];
    }
    add_outer(sums.l, dv, psi.slope);
  }
  void end(std::size_t i, const Sums& sums) const {
    for (int k = 0; k < D * D; ++k) gradient[i].c[k] = sum(sums.l.c[k]);
    for (int k = 0; k < D; ++k) fitted[i][k] = gather.records[i].v[k] + sum(sums.v[k]);
  }
};

/// The weight of those of the neighbours in j that are of particle i's material.
inline Pack within(const double* material, std::size_t i, const std::uint32_t* j, const Pack& weight) {
  const Pack other([&](auto lane) { return material[j[static_cast<std::size_t>(lane)]]; });
  return select(other == Pack(material[i]), weight, Pack(0.0));
}

/// Conservative smoothing of the velocity, eq. 3.23, with weights that are the same for both of a pair: m_j w_ij times
/// the mean of 1/Σ m w of both. So momentum is kept, and what the smoothing takes of the kinetic energy,
///   ½ α_cs Σ_j p_ij |v_j - v_i|² - ½ |Δv_i|²,
/// becomes heat: without it no shock could heat anything, because eq. 4.3 leaves e = 0 at zero. The energy is smoothed
/// by the same weights, which keep its sum.
template <class Kernel, int D>
struct SmoothVelocity {
  MsphGather<D> gather;
  const double* kernel_mass;  ///< of images too
  double share;               ///< α_cs
  const double* energy;       ///< J/kg, of images too
  const double* material;     ///< a number for each, of images too: heat stays within a material
  Vector<double, D>* change;  ///< m/s
  double* heat;               ///< J/kg, before the change's own part is taken off
  double* exchange;           ///< energy from the neighbours, J/kg

  using Self = MsphSelf<D>;
  struct Sums {
    Vector<Pack, D> v = Vector<Pack, D>::zero();
    Pack square = 0.0;
    Pack energy = 0.0;
  };
  Self begin(std::size_t i) const { return gather.self(i); }
  bool far(const Self& a, const std::uint32_t* j) const { return gather.far(a, j); }
  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    const auto& own = gather.records[a.i];
    const auto p = gather.pair(a, j);
    const Pack other([&](auto lane) { return 1.0 / kernel_mass[j[static_cast<std::size_t>(lane)]]; });
    const Pack weight = gather.template mutual_kernel<Kernel>(a, j, p) * gather.mass(j) * Pack(0.5) *
                        (other + Pack(1.0 / kernel_mass[a.i]));
    Vector<Pack, D> dv;
    for (int k = 0; k < D; ++k) {
      dv[k] = gather.read(j, [k](const auto& q) -> const double& { return q.v[k]; }) - Pack(own.v[k]);
      sums.v[k] += weight * dv[k];
    }
    sums.square += weight * dot(dv, dv);
    const Pack e([&](auto lane) { return energy[j[static_cast<std::size_t>(lane)]]; });
    sums.energy += within(material, a.i, j, weight) * (e - Pack(energy[a.i]));
  }
  void end(std::size_t i, const Sums& sums) const {
    for (int k = 0; k < D; ++k) change[i][k] = share * sum(sums.v[k]);
    heat[i] = 0.5 * share * sum(sums.square);
    exchange[i] = share * sum(sums.energy);
  }
};

/// Conservative smoothing of the density, eq. 3.23 as printed: weights W_ij m_j/ρ_j. Only within a material: across a
/// contact the density jumps by itself.
template <class Kernel, int D>
struct SmoothDensity {
  MsphGather<D> gather;
  const double* density;   ///< kg/m³, at the end of the step, of images too
  const double* material;  ///< a number for each, of images too
  double share;
  double* smoothed;

  using Self = MsphSelf<D>;
  struct Sums {
    Pack change = 0.0, weight = 0.0;
  };
  Self begin(std::size_t i) const { return gather.self(i); }
  bool far(const Self& a, const std::uint32_t* j) const { return gather.far(a, j); }
  void add(const Self& a, const std::uint32_t* j, Sums& sums) const {
    using std::experimental::sqrt;
    const auto p = gather.pair(a, j);
    const Pack other([&](auto lane) { return density[j[static_cast<std::size_t>(lane)]]; });
    const Pack near = select(p.volume > Pack(0.0), Kernel::shape(sqrt(p.distance_squared)), Pack(0.0)) * p.volume;
    const Pack weight = within(material, a.i, j, near);
    sums.change += weight * (other - Pack(density[a.i]));
    sums.weight += weight;
  }
  void end(std::size_t i, const Sums& sums) const {
    const double all = sum(sums.weight) + Kernel::shape(0.0) * gather.records[i].volume;
    smoothed[i] = density[i] + share * sum(sums.change) / all;
  }
};

}  // namespace tektite
