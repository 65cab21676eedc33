#pragma once
// Turns total-Lagrangian particles into Eulerian ones. Stress, density, energy and damage carry over: they are the same
// fields for both.

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "boundary/mirror.hpp"
#include "core/kernel_type.hpp"
#include "neighbours/pair_list.hpp"
#include "parallel/for_each.hpp"
#include "parallel/ranks.hpp"
#include "passes/conversion.hpp"
#include "passes/lagrangian_records.hpp"
#include "schemes/adaptle_settings.hpp"

namespace tektite {

template <int D>
class Converter {
 public:
  /// `refresh` as in SchemeSetup.
  Converter(Conversion settings, std::function<void(Field)> refresh)
      : settings_(settings), limit_(settings.strain), refresh_(std::move(refresh)) {}

  /// Converts who has reached the criterion, with its neighbours in the reference configuration, and the
  /// total-Lagrangian neighbours of an Eulerian particle whose F no longer describes it. So does a failed particle that
  /// had left the sums (without volume in `reference`) with its neighbours: they will see it again, where it has come
  /// to without them. True where any was.
  bool convert(Particles& particles, const PairList& pairs, const Mirror<D>& mirror,
               const std::vector<ReferenceRecord<D>>& reference, const std::vector<Tensor<double, D>>& deformation,
               const std::vector<StressRecord<D>>& stress) {
    const double* damage = particles.has(Field::damage) ? particles.scalars(Field::damage) : nullptr;
    const auto reached = [&](std::size_t i) {
      if (settings_.by == Conversion::By::damage) return damage && damage[i] >= 1.0;
      return settings_.by == Conversion::By::strain && limit_.exceeded_by(deformation[i]);
    };
    marked_.resize(particles.count());
    for_each(marked_.size(), [&](std::size_t i) {
      marked_[i] = reference[i].lagrangian != 0.0 ? reached(i) : !describes(deformation[i], stress[i].jacobian);
    });
    bool any = false;
    while (any_in(particles, marked_)) {
      any = turn_marked(particles, pairs, mirror) || any;
      for_each(marked_.size(), [&](std::size_t i) { marked_[i] = turned_[i] && reference[i].volume == 0.0; });
    }
    return any;
  }

 private:
  /// Of all ranks.
  static bool any_in(const Particles& particles, const std::vector<std::uint8_t>& marks) {
    return over_ranks(particles, std::ranges::find(marks, 1) != marks.end(), either);
  }

  /// Turns those that are marked, with their neighbours, and notes whom. A rank knows of its own particles and their
  /// neighbours who is marked; who of the copies further away has turned it takes from their owners.
  bool turn_marked(Particles& particles, const PairList& pairs, const Mirror<D>& mirror) {
    constexpr auto eulerian = static_cast<std::int64_t>(KernelType::eulerian);
    const auto types = particles.integers(Field::kernel_type);
    before_.assign(types.begin(), types.end());
    for (const auto& block : pairs.blocks())
      for (std::size_t k = 0; k + 1 < block.first.size(); ++k) {
        if (!marked_[block.begin + k]) continue;
        types[block.begin + k] = eulerian;
        for (auto n = block.first[k]; n < block.first[k + 1]; ++n)
          types[mirror.source_of(block.neighbours[n], particles.count())] = eulerian;
      }
    refresh_(Field::kernel_type);
    turned_.resize(types.size());
    for_each(turned_.size(), [&](std::size_t i) { turned_[i] = types[i] != before_[i]; });
    return any_in(particles, turned_);
  }

  /// Whether the volume by F and that by the density are the same within a factor of two. Where Eulerian particles flow
  /// past each other, the F that the reference configuration gives them loses its meaning, and with it what they do to
  /// total-Lagrangian neighbours (Young et al. 2021, section 3.3, convert "a large number of neighbours" for this).
  static bool describes(const Tensor<double, D>& f, double jacobian) {
    const double by_f = determinant(f);
    return by_f > 0.5 * jacobian && by_f < 2.0 * jacobian;
  }

  Conversion settings_;
  StrainLimit limit_;
  std::function<void(Field)> refresh_;
  std::vector<std::uint8_t> marked_, turned_;
  std::vector<std::int64_t> before_;  ///< kernel types
};

}  // namespace tektite
