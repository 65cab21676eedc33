#pragma once
// F of total-Lagrangian particles that lose neighbours which fail, with corrected gradients. What is left of the
// neighbours tells another gradient than all of them did, unless the motion is linear; F itself goes on from where it
// was, or pressure would come from nothing. From then on F = F_l M, with the F_l of what is left and the M that makes
// it what it was, F_l⁻¹ F: where all turns, so does F. M works as one correction more of the gradients in the reference
// configuration, so that forces stay the derivatives of the energy. Who has too few neighbours left for a correction
// has F = F_l + O, with the difference O at that moment.

#include <utility>
#include <vector>

#include "boundary/mirror.hpp"
#include "core/particles.hpp"
#include "core/tensor_algebra.hpp"
#include "neighbours/pair_list.hpp"
#include "parallel/for_each.hpp"
#include "parallel/unfused.hpp"
#include "passes/lagrangian_records.hpp"
#include "schemes/reference_correction.hpp"

namespace tektite {

template <class Kernel, int D>
class KeptDeformation {
  using Matrix = Tensor<double, D>;

 public:
  /// Of a run that goes on the field is as it was saved: M - I or O, and -I of who has left the sums.
  explicit KeptDeformation(Particles& particles) {
    if (!particles.has(Field::deformation_offset)) particles.allocate(Field::deformation_offset);
    offset_ = particles.template tensors<D>(Field::deformation_offset);
  }

  bool has_left(std::size_t i) const { return offset_[i](0, 0) == -1.0; }

  /// Before the particles for which leaves(i) says so leave the sums: notes who loses a neighbour by it, with the F
  /// that `deformed` holds. Nothing is added to that of who loses one until keep().
  template <class Leaves>
  void note(const PairList& pairs, const Mirror<D>& mirror, const std::vector<ReferenceRecord<D>>& reference,
            const std::vector<StressRecord<D>>& deformed, std::size_t count, const Leaves& leaves) {
    losing_.clear();
    for (const auto& block : pairs.blocks())
      for (std::size_t k = 0; k + 1 < block.first.size(); ++k) {
        const std::size_t i = block.begin + k;
        if (leaves(i) || !bears(reference[i])) continue;
        for (auto n = block.first[k]; n < block.first[k + 1]; ++n)
          if (leaves(mirror.source_of(block.neighbours[n], count))) {
            losing_.emplace_back(i, deformed[i].cofactor);
            break;
          }
      }
    for (const auto& [i, f] : losing_) offset_[i] = Matrix::zero();
    for_each(count, [&](std::size_t i) {
      if (leaves(i)) offset_[i] = -1.0 * unit();
    });
  }

  /// Afterwards, with the F_l that `deformed` holds now.
  void keep(const std::vector<StressRecord<D>>& deformed, ReferenceCorrection<Kernel, D>& corrections) {
    for_each(losing_.size(), [&](std::size_t n) {
      const auto& [i, f] = losing_[n];
      const auto& left = deformed[i].cofactor;
      if (!corrections.has(i)) {
        offset_[i] = f - left;
      } else if (const double j = determinant(left); j > least_moment_of_pieces<D> * determinant(f)) {
        offset_[i] = (1.0 / j) * product(transposed(cofactor(left)), f) - unit();
        turn(i, corrections);
      }  // else what is left says next to nothing of F: it is taken as it is
    });
  }

  /// Brings M into corrections that were found anew.
  void turn(const std::vector<ReferenceRecord<D>>& reference, ReferenceCorrection<Kernel, D>& corrections) const {
    for_each(corrections.count(), [&](std::size_t i) {
      if (bears(reference[i]) && corrections.has(i) && is_kept(i)) turn(i, corrections);
    });
  }

  /// F from the sums that `deformed` holds: I + Σ u ⊗ ∇̃W M + M - I, or + O.
  void add_to(std::vector<StressRecord<D>>& deformed, const std::vector<ReferenceRecord<D>>& reference,
              std::size_t count) const {
    for_each(count, [&](std::size_t i) {
      if (bears(reference[i]) && is_kept(i)) deformed[i].cofactor += offset_[i];
    });
  }

  std::size_t memory() const { return losing_.capacity() * sizeof(losing_[0]); }

 private:
  static bool bears(const ReferenceRecord<D>& r) { return r.lagrangian != 0.0 && r.volume != 0.0; }
  static Matrix unit() { return Correction<double, D>::none().matrix; }
  /// Adding a zero would take the sign of one.
  bool is_kept(std::size_t i) const {
    for (const double component : offset_[i].c)
      if (component != 0.0) return true;
    return false;
  }
  /// Rounded alike from wherever it is called: who has to turn anew, and when, depends on the ranks.
  TEKTITE_UNFUSED [[gnu::flatten]] void turn(std::size_t i, ReferenceCorrection<Kernel, D>& corrections) const {
    auto& matrix = corrections[i].matrix;
    matrix = product(transposed(unit() + offset_[i]), matrix);
  }

  Tensor<double, D>* offset_;
  std::vector<std::pair<std::size_t, Matrix>> losing_;  ///< with their F
};

}  // namespace tektite
