#pragma once
// Control of zero-energy modes of total-Lagrangian particles: their stiffness, and the two sweeps of
// passes/hourglass_sums.hpp.

#include <vector>

#include "boundary/mirror.hpp"
#include "core/particles.hpp"
#include "core/saved_number.hpp"
#include "parallel/for_each.hpp"
#include "parallel/sums.hpp"
#include "passes/hourglass_sums.hpp"
#include "schemes/reference_neighbours.hpp"

namespace tektite {

template <class Kernel, int D>
class HourglassControl {
 public:
  /// k = `coefficient` times the shear modulus of a particle's material. Materials: the MaterialPasses.
  template <class Materials>
  HourglassControl(std::size_t count, const Materials& materials, double coefficient)
      : stiffness_(count), power_(count) {
    materials.for_each_run([&](const auto& run) {
      const double modulus = shear_modulus_of(*run.material);
      run_through(run.range, [&](std::size_t i) { stiffness_[i] = coefficient * modulus; });
    });
  }

  /// Of rings, whose volumes in the reference records are areas: k for the whole circumference of each.
  void turn_into_rings(const double* circumference) {
    for (std::size_t i = 0; i < stiffness_.size(); ++i) stiffness_[i] *= circumference[i];
  }

  /// Adds to the accelerations in the middle of a step of dt.
  void add_forces(const ReferenceNeighbours<Kernel, D>& neighbours, const Mirror<D>& mirror,
                  const std::vector<ReferenceRecord<D>>& reference, const std::vector<MotionRecord<D>>& motion,
                  const Particles& particles, Vector<double, D>* acceleration, double dt) {
    const double* const mass = particles.scalars(Field::mass);
    fits_.resize(reference.size());
    ListedRecords<D> records{reference.data(), motion.data()};
    neighbours.sweep(records, [&]<class Records>(const Records& r) {
      return FitMotion<Kernel, D, Records>{{r, reference.data()}, stiffness_.data(), fits_.data()};
    });
    mirror.fill(fits_, stiffness_.size());
    records.hourglass = fits_.data();
    neighbours.sweep(records, [&]<class Records>(const Records& r) {
      return HourglassForces<Kernel, D, Records>{{r, reference.data()}, fits_.data(), motion.data(), mass,
                                                 acceleration,          power_.data()};
    });
    energy_ += dt * work_sum_(particles, [this](std::size_t i) { return std::array{power_[i]}; })[0];
  }

  /// The work done against the control so far: what it stores, and what it stored where particles have failed, J.
  double energy() const { return energy_; }

  void restore(const std::map<std::string, double>& state) { energy_ = saved_number(state, "hourglass_energy"); }
  void save(std::map<std::string, double>& state) const { state["hourglass_energy"] = energy_; }

  std::size_t memory() const {
    return (stiffness_.capacity() + power_.capacity()) * sizeof(double) + fits_.capacity() * sizeof(HourglassRecord<D>);
  }

 private:
  std::vector<double> stiffness_, power_;
  std::vector<HourglassRecord<D>> fits_;
  double energy_ = 0.0;
  RepeatedSum<1> work_sum_;
};

}  // namespace tektite
