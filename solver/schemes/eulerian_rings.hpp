#pragma once
// The rings of the scheme eulerian in an axisymmetric space: their circumference, rate, force and heat.

#include <vector>

#include "boundary/mirror.hpp"
#include "core/particles.hpp"
#include "neighbours/pair_list.hpp"
#include "parallel/for_each.hpp"
#include "parallel/for_each_pair.hpp"
#include "passes/eulerian_rings.hpp"

namespace tektite {

template <class Kernel>
class EulerianRings {
 public:
  using Records = std::vector<EulerianRecord<2>>;

  /// Rates on the way to the middle of a step.
  void predict(Particles& p, const Range& range) const {
    run_through(range, PredictRings{p.vectors<2>(Field::position), p.vectors<2>(Field::velocity),
                                    p.tensors<2>(Field::velocity_gradient), p.scalars(Field::mass),
                                    p.scalars(Field::density), p.scalars(Field::across_rate)});
  }

  /// Sections in the middle of a step, where the records are by now; and what the ring's stress did on the way.
  void measure(Particles& p, const Range& range, double half_step, const Records& records) {
    run_through(range, HeatRings{p.symmetrics<2>(Field::deviatoric_stress), p.scalars(Field::pressure),
                                 p.scalars(Field::density), p.scalars(Field::across_rate), half_step,
                                 p.scalars(Field::half_energy)});
    run_through(range, MeasureRings{records.data(), p.scalars(Field::mass), p.scalars(Field::half_density),
                                    p.scalars(Field::thickness), p.scalars(Field::across_rate), half_step,
                                    spacing_of(p, range), sections_.data(), circumference_.data()});
  }

  /// Takes part in the whole records.
  void show(Particles& p, const Range& range, Records& records) {
    run_through(range, ShowRings{p.symmetrics<2>(Field::half_deviatoric_stress), p.scalars(Field::half_pressure),
                                 sections_.data(), records.data(), rings_.data()});
  }

  void resize(const Particles& p, const Mirror<2>& mirror) {
    sections_.resize(p.count());
    circumference_.resize(p.count());
    own_rate_.resize(p.count());
    smoothed_.resize(p.count());
    mirror.fit(rings_, p.count());
  }
  void fill_images(const Particles& p, const Mirror<2>& mirror) { mirror.fill(rings_, p.count()); }

  /// Rates and forces, where the velocity gradient and the accelerations of the section are known.
  void turn(Particles& p, const PairList& pairs) {
    for_each_pair(pairs, RingSums<Kernel, 2>{rings_.data(), smoothed_.data(), nullptr});
    for_each(p.count(), TurnRings{rings_.data(), sections_.data(), smoothed_.data(),
                                  p.tensors<2>(Field::velocity_gradient), p.scalars(Field::mass), own_rate_.data(),
                                  p.scalars(Field::across_rate), p.vectors<2>(Field::acceleration)});
  }

  /// What the ring's stress does by its own motion over a step; that of the section's record has done the rest.
  void heat(Particles& p, const Range& range, double step) const {
    const HeatRings heat{p.symmetrics<2>(Field::half_deviatoric_stress),
                         p.scalars(Field::half_pressure),
                         p.scalars(Field::half_density),
                         own_rate_.data(),
                         step,
                         p.scalars(Field::specific_internal_energy)};
    run_through(range, heat);
  }

  void pass_through_axis(Particles& p, const Range& range) const {
    run_through(range, PassThroughAxis{p.vectors<2>(Field::position), p.vectors<2>(Field::velocity),
                                       p.vectors<2>(Field::acceleration), p.tensors<2>(Field::velocity_gradient),
                                       p.symmetrics<2>(Field::deviatoric_stress)});
  }

  const double* circumference() const { return circumference_.data(); }
  std::size_t memory() const {
    return rings_.capacity() * sizeof(RingRecord<2>) + sections_.capacity() * sizeof(RingSection) +
           smoothed_.capacity() * sizeof(Vector<double, 2>) +
           (circumference_.capacity() + own_rate_.capacity()) * sizeof(double);
  }

 private:
  static double spacing_of(const Particles& p, const Range& range) {
    for (const auto& body : p.bodies())
      if (range.begin >= body.range.begin && range.begin < body.range.end) return body.spacing;
    return 0.0;
  }

  std::vector<RingSection> sections_;
  std::vector<double> circumference_;
  std::vector<double> own_rate_;
  std::vector<Vector<double, 2>> smoothed_;
  std::vector<RingRecord<2>> rings_;
};

}  // namespace tektite
