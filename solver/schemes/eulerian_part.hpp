#pragma once
// The Eulerian particles of bodies whose others are total-Lagrangian: Young et al. (2021), section 2.2. They sum over
// all that are near them in the present configuration, whatever their kernels.

#include <map>

#include "neighbours/neighbourhood.hpp"
#include "neighbours/reference_pairs.hpp"
#include "parallel/reduce.hpp"
#include "passes/assemble_records.hpp"
#include "passes/lagrangian_records.hpp"
#include "schemes/corrected_sums.hpp"

namespace tektite {

template <class Kernel, int D>
class EulerianPart {
 public:
  EulerianPart(Particles& particles, double support, std::vector<SymmetryPlane> planes, const SchemeSettings& settings)
      : particles_(particles),
        neighbourhood_(particles, support, std::move(planes),
                       {Pairing::within_bodies, false, Field::search_position,
                        settings.corrected_eulerian ? Listed::eulerian_and_near : Listed::eulerian}),
        sums_(settings) {}

  void start() {
    particles_.allocate(Field::search_position);
    renew();
  }
  void restore(const std::map<std::string, double>& state) {
    note();
    neighbourhood_.restore(state);
  }
  void save(std::map<std::string, double>& state) const { neighbourhood_.save(state); }

  /// Some particles have another kernel type than before.
  void renew() {
    note();
    if (any()) neighbourhood_.renew(0.0);
  }
  /// Makes the search good for a step dt.
  void prepare(double dt) {
    if (any()) neighbourhood_.prepare(dt);
  }
  /// Of distributed particles: what the sums reach, if any are made; whether a step of dt needs a search, and its
  /// beginning, which restore() ends.
  Halos halos(const std::map<std::string, double>& state) const {
    const auto halo = neighbourhood_.halo(state, sums_.sweeps());
    return halo.width > 0.0 ? Halos{halo} : Halos{};
  }
  bool search_is_due(double dt) { return any() && neighbourhood_.due(dt); }
  void begin_search(double dt) { neighbourhood_.begin(dt); }

  bool any() const { return count_ > 0; }
  /// Of all ranks.
  std::size_t count() const { return count_; }
  /// Eulerian particles that go without correction.
  std::size_t without_correction() const { return sums_.without(); }

  /// The rates of the Eulerian particles. `motion` is the middle of the step, as the half fields are; who has no volume
  /// in `reference` has failed and is nobody's neighbour, here as there: it would push without being pushed.
  void evaluate(const std::vector<MotionRecord<D>>& motion, const std::vector<ReferenceRecord<D>>& reference) {
    if (!any()) return;
    auto& p = particles_;
    records_.resize(p.count());
    const AssembleRecords<D, false> assemble{p.scalars(Field::mass),
                                             p.scalars(Field::half_density),
                                             p.scalars(Field::half_pressure),
                                             p.scalars(Field::half_sound_speed),
                                             p.template symmetrics<D>(Field::half_deviatoric_stress),
                                             nullptr,
                                             nullptr,
                                             0.0,
                                             p.scalars(Field::smoothing_length),
                                             records_.data()};
    const auto& members = neighbourhood_.members();
    for_each(members.size(), [&](std::size_t n) {
      const std::size_t i = members[n];
      records_[i].x = motion[i].x;
      records_[i].v = motion[i].v;
      assemble(i);
      if (reference[i].volume == 0.0) records_[i].volume = 0.0;
    });
    const typename CorrectedSums<Kernel, D>::Among among{members, eulerian_.data()};
    sums_.evaluate(p, neighbourhood_.pairs(), neighbourhood_.mirror(), records_, nullptr, among);
  }

  std::size_t memory() const {
    return neighbourhood_.memory() + sums_.memory() + records_.capacity() * sizeof(EulerianRecord<D>) +
           eulerian_.capacity();
  }

 private:
  void note() {
    eulerian_ = eulerian_of_each(particles_);
    count_ = count_over(particles_, {0, particles_.count()}, [&](std::size_t i) { return eulerian_[i] != 0; });
  }

  Particles& particles_;
  Neighbourhood<D> neighbourhood_;
  CorrectedSums<Kernel, D> sums_;
  std::vector<EulerianRecord<D>> records_;
  std::vector<std::uint8_t> eulerian_;
  std::size_t count_ = 0;
};

}  // namespace tektite
