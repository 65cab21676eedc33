#pragma once
// The rings of the total-Lagrangian scheme in an axisymmetric space: their stretch, their stress and their force.

#include <vector>

#include "boundary/mirror.hpp"
#include "core/particles.hpp"
#include "neighbours/pair_list.hpp"
#include "parallel/for_each.hpp"
#include "parallel/for_each_pair.hpp"
#include "passes/lagrangian_rings.hpp"

namespace tektite {

template <class Kernel>
class LagrangianRings {
 public:
  using Reference = std::vector<ReferenceRecord<2>>;

  /// Circumferences; the volumes of the reference records become areas of the section.
  void prepare(const Particles& particles, Reference& reference) {
    const auto count = particles.count();
    for (auto* column : {&circumference_, &stretch_, &hoop_force_}) column->resize(count);
    for (auto* column : {&offset_, &motion_}) column->resize(count);
    force_.resize(count);
    for (const auto& body : particles.bodies())
      for (auto i = body.range.begin; i < body.range.end; ++i) {
        circumference_[i] = circumference(mean_radius(reference[i].x[0], body.spacing));
        reference[i].volume /= circumference_[i];
      }
  }

  /// The mean offset of the neighbours, from the whole reference records.
  void find_offsets(const PairList& pairs, const Mirror<2>& mirror, const Reference& reference) {
    show(motion_records_, mirror, reference, [](std::size_t) { return Vector<double, 2>::zero(); });
    for_each_pair(pairs, RingSums<Kernel, 2>{motion_records_.data(), motion_.data(), offset_.data()});
  }

  /// λ and its rate over λ, from the motion and the records with F and its rate of the middle of a step.
  void stretch(const PairList& pairs, const Mirror<2>& mirror, const Reference& reference,
               const std::vector<MotionRecord<2>>& motion, const std::vector<StressRecord<2>>& records,
               double* across_rate) {
    show(motion_records_, mirror, reference, [&](std::size_t i) {
      return Vector<double, 2>{motion[i].x[0] - reference[i].x[0], motion[i].v[0]};
    });
    for_each_pair(pairs, RingSums<Kernel, 2>{motion_records_.data(), motion_.data(), nullptr});
    for_each(stretch_.size(), StretchRings{reference.data(), records.data(), motion_.data(), offset_.data(),
                                           stretch_.data(), across_rate});
  }

  void turn_stress(const Particles& p, const Range& range, const Reference& reference,
                   std::vector<StressRecord<2>>& stress) {
    run_through(range, RingStress{reference.data(), circumference_.data(), stretch_.data(), offset_.data(),
                                  p.symmetrics<2>(Field::half_deviatoric_stress), p.scalars(Field::half_pressure),
                                  stress.data(), hoop_force_.data()});
  }

  /// -A 𝓢q/m along the radius.
  void add_forces(const PairList& pairs, const Mirror<2>& mirror, const Reference& reference, const double* mass,
                  Vector<double, 2>* acceleration) {
    show(force_records_, mirror, reference, [&](std::size_t i) { return Vector<double, 1>{hoop_force_[i]}; });
    for_each_pair(pairs, RingSums<Kernel, 1>{force_records_.data(), force_.data(), nullptr});
    for_each(force_.size(), [&](std::size_t i) { acceleration[i][0] -= reference[i].volume / mass[i] * force_[i][0]; });
  }

  const double* stretch_of_each() const { return stretch_.data(); }
  const double* circumference_of_each() const { return circumference_.data(); }  ///< in the reference configuration, m

  std::size_t memory() const {
    return motion_records_.capacity() * sizeof(RingRecord<2>) + force_records_.capacity() * sizeof(RingRecord<1>) +
           (circumference_.capacity() + stretch_.capacity() + hoop_force_.capacity() + 2 * offset_.capacity() +
            2 * motion_.capacity() + force_.capacity()) *
               sizeof(double);
  }

 private:
  /// Fills records with the numbers of each particle, in the reference configuration.
  template <int numbers, class Odd>
  static void show(std::vector<RingRecord<numbers>>& records, const Mirror<2>& mirror, const Reference& reference,
                   const Odd& odd) {
    const auto count = reference.size() - mirror.images();
    records.resize(reference.size());
    for_each(count, [&](std::size_t i) {
      records[i] = {reference[i].x, reference[i].volume, reference[i].smoothing_length, odd(i)};
    });
    mirror.fill(records, count);
  }

  std::vector<double> circumference_, stretch_, hoop_force_;
  std::vector<Vector<double, 2>> offset_, motion_;
  std::vector<Vector<double, 1>> force_;
  std::vector<RingRecord<2>> motion_records_;
  std::vector<RingRecord<1>> force_records_;
};

}  // namespace tektite
