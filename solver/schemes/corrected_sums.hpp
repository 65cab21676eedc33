#pragma once
// The Eulerian sums beyond the plain ones: with the mixed correction, with artificial stress, or where some neighbours
// are total-Lagrangian.

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/particles.hpp"
#include "parallel/for_each_pair.hpp"
#include "passes/corrected_rates.hpp"
#include "schemes/mixed_correction.hpp"
#include "schemes/scheme.hpp"

namespace tektite {

template <class Kernel, int D>
class CorrectedSums {
 public:
  explicit CorrectedSums(const SchemeSettings& settings)
      : viscosity_(settings.viscosity),
        corrected_(settings.corrected_eulerian),
        switch_{settings.correction_limit},
        artificial_(settings.artificial_stress) {}

  /// Whether these settings ask for more than the plain sums.
  static bool needed(const SchemeSettings& settings) {
    return settings.corrected_eulerian || settings.artificial_stress;
  }

  /// Where some particles are total-Lagrangian.
  struct Among {
    std::span<const std::uint32_t> members;  ///< those whose records are read, in ascending order
    const std::uint8_t* eulerian;            ///< a byte each
  };

  /// Accelerations, velocity gradients and viscous powers of the Eulerian particles. `records` are those of the
  /// particles alone, `strain_rates` also those of their images: null where the viscosity does not read them.
  void evaluate(Particles& p, const PairList& pairs, const Mirror<D>& mirror,
                const std::vector<EulerianRecord<D>>& records, const StrainRateRecord<D>* strain_rates,
                const std::optional<Among>& among = {}) {
    const auto count = p.count();
    mirror.fit(records_, count);
    for (const auto& body : p.bodies()) {
      const auto members = among ? members_in(body.range, among->members) : std::span<const std::uint32_t>();
      for_each(among ? members.size() : body.range.size(), [&](std::size_t n) {
        const std::size_t i = among ? members[n] : body.range.begin + n;
        fill(records_[i], records[i], body.spacing, !among || among->eulerian[i]);
      });
    }
    mirror.fill(records_, count);
    without_ =
        corrected_ ? correction_.find(pairs, mirror, records_, count, among ? among->eulerian : nullptr, Owned(p)) : 0;
    if (corrected_)
      sum<true>(p, pairs, strain_rates);
    else
      sum<false>(p, pairs, strain_rates);
  }

  /// Sweeps over pairs, one behind the other.
  int sweeps() const { return corrected_ ? 2 : 1; }
  /// Own particles that go without correction, at the last call.
  std::size_t without() const { return without_; }
  std::size_t memory() const { return records_.capacity() * sizeof(CorrectedRecord<D>); }

 private:
  void fill(CorrectedRecord<D>& r, const EulerianRecord<D>& plain, double spacing, bool eulerian) const {
    static_cast<EulerianRecord<D>&>(r) = plain;
    r.correction = Correction<double, D>::none();
    r.spacing = spacing;
    r.eulerian = eulerian ? 1.0 : 0.0;
    const bool meets = artificial_ && artificial_->interface != ArtificialStressInterface::none;
    r.pushes = eulerian || meets ? 1.0 : 0.0;
    for (auto& component : r.artificial) component = 0.0;
    if constexpr (D == 2) {
      if (artificial_) artificial_->tensor(r.stress, r.density, r.artificial);
    }
  }

  template <bool corrected>
  void sum(Particles& p, const PairList& pairs, const StrainRateRecord<D>* strain_rates) {
    if constexpr (D == 2) {
      if (artificial_) return sum<corrected, true>(p, pairs, strain_rates);
    }
    sum<corrected, false>(p, pairs, strain_rates);
  }

  template <bool corrected, bool artificial>
  void sum(Particles& p, const PairList& pairs, const StrainRateRecord<D>* strain_rates) {
    std::visit(
        [&]<class Chosen>(const Chosen& viscosity) {
          for_each_pair(pairs,
                        CorrectedRates<Kernel, Chosen, D, corrected, artificial>{
                            records_.data(), viscosity, switch_, artificial_ ? artificial_->exponent : 0,
                            p.template vectors<D>(Field::acceleration), p.template tensors<D>(Field::velocity_gradient),
                            p.scalars(Field::viscous_power), p.scalars(Field::viscous_signal), strain_rates});
        },
        viscosity_);
  }

  Viscosity viscosity_;
  bool corrected_;
  CorrectionSwitch switch_;
  std::optional<ArtificialStress> artificial_;
  MixedCorrection<Kernel, D> correction_{least_moment_of_pieces<D>};
  std::vector<CorrectedRecord<D>> records_;
  std::size_t without_ = 0;
};

}  // namespace tektite
