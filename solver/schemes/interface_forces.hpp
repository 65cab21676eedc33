#pragma once
// Artificial stress of Eulerian particles on total-Lagrangian ones, for the scheme adaptle in the plane: finds the
// pairs of the reference configuration in which both kinds meet, and adds the forces over those alone.

#include <vector>

#include "boundary/mirror.hpp"
#include "core/particles.hpp"
#include "neighbours/pair_list.hpp"
#include "parallel/for_each_pair.hpp"
#include "passes/interface_stress.hpp"
#include "schemes/scheme.hpp"

namespace tektite {

template <class Kernel>
class InterfaceForces {
 public:
  explicit InterfaceForces(const SchemeSettings& settings) : settings_(settings.artificial_stress) {}

  /// Lists the pairs of `pairs` that meet, after particles have turned Eulerian; none where the scene asks for no
  /// artificial stress of both kinds on each other.
  void list(const PairList& pairs, const Mirror<2>& mirror, const std::vector<ReferenceRecord<2>>& reference,
            std::size_t count) {
    if (!settings_ || settings_->interface != ArtificialStressInterface::both) return;
    const auto lagrangian = [&](std::size_t i) { return reference[i].lagrangian != 0.0; };
    meeting_ = pairs;
    meeting_.keep_pairs([&](std::size_t i, std::size_t j) { return lagrangian(i) && !lagrangian(j); });
    meeting_.drop_empty_runs();
    members_ = meeting_.members(count, [&](std::uint32_t j) { return mirror.source_of(j, count); });
  }

  /// Adds to accelerations and viscous powers, in the middle of a step.
  void add(Particles& p, const Mirror<2>& mirror, const std::vector<ReferenceRecord<2>>& reference,
           const std::vector<MotionRecord<2>>& motion, const std::vector<StressRecord<2>>& stress,
           const std::vector<ShiftRecord<2>>& shift) {
    if (members_.empty()) return;
    mirror.fit(records_, p.count());
    for (const auto& body : p.bodies()) {
      const auto members = members_in(body.range, members_);
      for_each(members.size(), [&](std::size_t n) { fill(p, members[n], body.spacing); });
    }
    mirror.fill(records_, p.count());
    for_each_pair(meeting_,
                  InterfaceStress<Kernel>{reference.data(), motion.data(), stress.data(), shift.data(), records_.data(),
                                          *settings_, p.scalars(Field::mass), p.vectors<2>(Field::acceleration),
                                          p.scalars(Field::viscous_power)});
  }

  std::size_t memory() const {
    return meeting_.memory() + members_.capacity() * sizeof(std::uint32_t) +
           records_.capacity() * sizeof(ArtificialStressRecord);
  }

 private:
  void fill(const Particles& p, std::size_t i, double spacing) {
    const auto& deviator = p.symmetrics<2>(Field::half_deviatoric_stress)[i];
    const double pressure = p.scalars(Field::half_pressure)[i];
    const double stress[3] = {deviator(0, 0) - pressure, deviator(1, 1) - pressure, deviator(0, 1)};
    settings_->tensor(stress, p.scalars(Field::half_density)[i], records_[i].r);
    records_[i].spacing = spacing;
  }

  std::optional<ArtificialStress> settings_;
  PairList meeting_;  ///< of total-Lagrangian particles, their Eulerian neighbours
  std::vector<std::uint32_t> members_;
  std::vector<ArtificialStressRecord> records_;
};

}  // namespace tektite
