#pragma once
// Turns total-Lagrangian particles into Eulerian ones. Stress, density, energy and damage carry over: they are the same
// fields for both.

#include <algorithm>
#include <vector>

#include "boundary/mirror.hpp"
#include "core/kernel_type.hpp"
#include "neighbours/pair_list.hpp"
#include "parallel/for_each.hpp"
#include "passes/conversion.hpp"
#include "passes/lagrangian_records.hpp"
#include "schemes/adaptle_settings.hpp"

namespace tektite {

template <int D>
class Converter {
 public:
  explicit Converter(Conversion settings) : settings_(settings), limit_(settings.strain) {}

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
    if (std::ranges::find(marked_, 1) == marked_.end()) return false;
    const auto types = particles.integers(Field::kernel_type);
    bool any = false, more = true;
    const auto turn = [&](std::size_t i) {
      constexpr auto eulerian = static_cast<std::int64_t>(KernelType::eulerian);
      if (types[i] == eulerian) return;
      types[i] = eulerian;
      any = true;
      if (reference[i].volume != 0.0) return;
      next_[i] = 1;
      more = true;
    };
    while (more) {
      more = false;
      next_.assign(marked_.size(), 0);
      for (const auto& block : pairs.blocks())
        for (std::size_t k = 0; k + 1 < block.first.size(); ++k) {
          if (!marked_[block.begin + k]) continue;
          turn(block.begin + k);
          for (auto n = block.first[k]; n < block.first[k + 1]; ++n)
            turn(mirror.source_of(block.neighbours[n], particles.count()));
        }
      marked_.swap(next_);
    }
    return any;
  }

 private:
  /// Whether the volume by F and that by the density are the same within a factor of two. Where Eulerian particles flow
  /// past each other, the F that the reference configuration gives them loses its meaning, and with it what they do to
  /// total-Lagrangian neighbours (Young et al. 2021, section 3.3, convert "a large number of neighbours" for this).
  static bool describes(const Tensor<double, D>& f, double jacobian) {
    const double by_f = determinant(f);
    return by_f > 0.5 * jacobian && by_f < 2.0 * jacobian;
  }

  Conversion settings_;
  StrainLimit limit_;
  std::vector<std::uint8_t> marked_, next_;
};

}  // namespace tektite
