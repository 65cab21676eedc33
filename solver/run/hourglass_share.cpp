#include "run/hourglass_share.hpp"

#include "core/tensor_algebra.hpp"
#include "core/tensor_product.hpp"
#include "neighbours/cell_grid.hpp"
#include "parallel/for_each.hpp"
#include "parallel/sums.hpp"
#include "run/lagrangian.hpp"

namespace tektite {
namespace {

/// Of the spacing: the neighbours of a square lattice along its axes and diagonals.
constexpr double reach = 1.6;

/// Of the determinant that the same trace has in all directions alike: neighbours below it do not span the space.
constexpr double flat = 1e-3;

/// Square of a strain that is round-off of places: a body that flies far does not deform by it.
constexpr double round_off = 1e-18;

/// Not seen and seen by the kernels, J.
using Energies = std::array<double, 2>;

template <int D>
class Bonds {
 public:
  Bonds(const Particles& particles, const Body& body, double shear_modulus, double bulk_modulus)
      : particles_(particles),
        shear_modulus_(shear_modulus),
        bulk_modulus_(bulk_modulus),
        longest_(reach * body.spacing) {
    const double* damage = optional(Field::damage);
    for (auto i = body.range.begin; i < body.range.end; ++i) {
      const bool failed = damage && damage[i] >= 1.0;
      if (failed || !is_lagrangian(particles, i)) continue;
      members_.push_back(i);
      reference_.push_back(particles.vectors<D>(Field::reference_position)[i]);
    }
    if (!reference_.empty()) grid_.build(reference_, longest_);
  }

  Energies sum(const Range& range) const {
    std::vector<Energies> energies(range.size(), Energies{});
    for_each(members_.size(), [&](std::size_t n) { energies[members_[n] - range.begin] = energies_of(n); });
    return sum_over<2>(particles_, range, [&](std::size_t i) { return energies[i - range.begin]; });
  }

 private:
  const double* optional(Field field) const { return particles_.has(field) ? particles_.scalars(field) : nullptr; }

  /// work(Ξ, u) for the neighbours of a member.
  template <class Work>
  void for_each_bond(std::size_t n, const Work& work) const {
    const auto* x = particles_.vectors<D>(Field::position);
    for (const auto cell : grid_.around(grid_.cell_of(reference_[n])))
      for (const auto m : grid_.members(cell)) {
        const auto bond = reference_[m] - reference_[n];
        if (m != n && norm(bond) < longest_) work(bond, (x[members_[m]] - x[members_[n]]) - bond);
      }
  }

  /// D Σ|e|²/Σ|Ξ|², zero where the neighbours do not span the space and where it is round-off.
  double mismatch(std::size_t n) const {
    auto moment = Tensor<double, D>::zero(), motion = Tensor<double, D>::zero();
    for_each_bond(n, [&](const auto& bond, const auto& u) {
      add_outer(moment, bond, bond);
      add_outer(motion, u, bond);
    });
    const double spanned = determinant(moment);
    double scale = 1.0;
    for (int k = 0; k < D; ++k) scale *= trace(moment) / D;
    if (!(spanned > flat * scale)) return 0.0;
    auto gradient = product_with_transposed(motion, cofactor(moment));
    for (auto& component : gradient.c) component /= spanned;
    double missed = 0.0;
    for_each_bond(n, [&](const auto& bond, const auto& u) {
      const auto error = times(gradient, bond) - u;
      missed += dot(error, error);
    });
    const double mismatch = D * missed / trace(moment);
    return mismatch > round_off ? mismatch : 0.0;
  }

  Energies energies_of(std::size_t n) const {
    const auto i = members_[n];
    const double mass = particles_.scalars(Field::mass)[i], volume = mass / particles_.scalars(Field::density)[i];
    const double pressure = particles_.scalars(Field::pressure)[i];
    const auto& s = particles_.symmetrics<D>(Field::deviatoric_stress)[i];
    double seen = volume * (0.5 * pressure * pressure / bulk_modulus_ + 0.25 * contract(s, s) / shear_modulus_);
    for (const auto* work : {optional(Field::plastic_work), optional(Field::viscous_work)})
      if (work) seen += mass * work[i];
    return {volume * shear_modulus_ * mismatch(n), seen};
  }

  const Particles& particles_;
  double shear_modulus_, bulk_modulus_, longest_;
  std::vector<std::size_t> members_;
  std::vector<Vector<double, D>> reference_;
  CellGrid<D> grid_;
};

template <int D>
double share_in(const Particles& particles, const Body& body, double shear_modulus, double bulk_modulus) {
  const auto [unseen, seen] = Bonds<D>(particles, body, shear_modulus, bulk_modulus).sum(body.range);
  return unseen > 0.0 ? unseen / (unseen + seen) : 0.0;
}

}  // namespace

double hourglass_share(const Particles& particles, const Body& body, const Material& material) {
  const double shear = shear_modulus_of(material);
  if (!particles.has(Field::reference_position) || shear == 0.0) return 0.0;
  const double bulk = bulk_modulus_of(material);
  return particles.dimensions() == 1   ? share_in<1>(particles, body, shear, bulk)
         : particles.dimensions() == 2 ? share_in<2>(particles, body, shear, bulk)
                                       : share_in<3>(particles, body, shear, bulk);
}

}  // namespace tektite
