#include "run/bond_mismatch.hpp"

#include "core/kernel_type.hpp"
#include "core/tensor_algebra.hpp"
#include "core/tensor_product.hpp"
#include "neighbours/cell_grid.hpp"
#include "parallel/reduce.hpp"

namespace tektite {
namespace {

/// Of the spacing: the neighbours of a square lattice along its axes and diagonals.
constexpr double reach = 1.6;

/// What a mismatch has to exceed, over the bonds' lengths, to be more than rounding.
constexpr double rounding = 1e-9;

struct Mismatch {
  double missed = 0.0, seen = 0.0, length = 0.0;  ///< sums of squares, times mass
};

template <int D>
struct Bonds {
  std::vector<Vector<double, D>> reference, displacement;
  std::vector<double> mass;
  CellGrid<D> grid;
  double longest;

  Bonds(const Particles& particles, const Body& body) : longest(reach * body.spacing) {
    const auto types = particles.integers(Field::kernel_type);
    const double* damage = particles.has(Field::damage) ? particles.scalars(Field::damage) : nullptr;
    const auto *places = particles.vectors<D>(Field::reference_position), *now = particles.vectors<D>(Field::position);
    for (auto i = body.range.begin; i < body.range.end; ++i) {
      const bool failed = damage && damage[i] >= 1.0;
      if (failed || types[i] != static_cast<std::int64_t>(KernelType::total_lagrangian)) continue;
      reference.push_back(places[i]);
      displacement.push_back(now[i] - places[i]);
      mass.push_back(particles.scalars(Field::mass)[i]);
    }
    if (!reference.empty()) grid.build(reference, longest);
  }

  template <class Work>
  void for_each_bond(std::size_t i, const Work& work) const {
    for (const auto cell : grid.around(grid.cell_of(reference[i])))
      for (const auto j : grid.members(cell)) {
        const auto bond = reference[j] - reference[i];
        if (j != i && norm(bond) < longest) work(bond, displacement[j] - displacement[i]);
      }
  }

  void add(Mismatch& sums, std::size_t i) const {
    auto moment = Tensor<double, D>::zero(), motion = Tensor<double, D>::zero();
    for_each_bond(i, [&](const auto& bond, const auto& u) {
      add_outer(moment, bond, bond);
      add_outer(motion, u, bond);
    });
    const double spanned = determinant(moment);
    double scale = 1.0;
    for (int k = 0; k < D; ++k) scale *= trace(moment) / D;
    if (!(spanned > 1e-3 * scale)) return;
    auto gradient = product_with_transposed(motion, cofactor(moment));
    for (auto& component : gradient.c) component /= spanned;
    for_each_bond(i, [&](const auto& bond, const auto& u) {
      const auto expected = times(gradient, bond);
      const auto error = expected - u;
      // 2 E Ξ = G Ξ + Gᵀ (Ξ + G Ξ)
      Vector<double, D> strained = expected;
      for (int k = 0; k < D; ++k)
        for (int l = 0; l < D; ++l) strained[k] += gradient(l, k) * (bond[l] + expected[l]);
      sums.missed += mass[i] * dot(error, error);
      sums.seen += mass[i] * 0.25 * dot(strained, strained);
      sums.length += mass[i] * dot(bond, bond);
    });
  }
};

template <int D>
double mismatch_in(const Particles& particles, const Body& body) {
  const Bonds<D> bonds(particles, body);
  const auto sums = reduce(
      bonds.reference.size(), Mismatch{}, [&](Mismatch& part, std::size_t i) { bonds.add(part, i); },
      [](Mismatch& whole, const Mismatch& part) {
        whole.missed += part.missed;
        whole.seen += part.seen;
        whole.length += part.length;
      });
  if (!(sums.missed > rounding * rounding * sums.length)) return 0.0;
  return sums.missed / (sums.missed + sums.seen);
}

}  // namespace

double bond_mismatch(const Particles& particles, const Body& body) {
  if (!particles.has(Field::reference_position)) return 0.0;
  switch (particles.dimensions()) {
    case 1:
      return mismatch_in<1>(particles, body);
    case 2:
      return mismatch_in<2>(particles, body);
    default:
      return mismatch_in<3>(particles, body);
  }
}

}  // namespace tektite
