#pragma once

#include <algorithm>
#include <optional>

#include "boundary/kernel_contact.hpp"
#include "boundary/stop_at_anvil.hpp"
#include "boundary/walls.hpp"
#include "neighbours/neighbourhood.hpp"
#include "parallel/for_each_pair.hpp"
#include "passes/advance_motion.hpp"
#include "passes/assemble_records.hpp"
#include "passes/body_contact.hpp"
#include "passes/eulerian_rates.hpp"
#include "passes/predict_motion.hpp"
#include "passes/smoothing.hpp"
#include "schemes/corrected_sums.hpp"
#include "schemes/eulerian_rings.hpp"
#include "schemes/half_state.hpp"
#include "schemes/hold_still.hpp"
#include "schemes/make_scheme_in.hpp"
#include "schemes/material_passes.hpp"
#include "schemes/scheme.hpp"
#include "schemes/searches.hpp"
#include "schemes/state_sums.hpp"

namespace tektite {

template <Space space, class Kernel>
class EulerianScheme final : public Scheme {
  static constexpr int D = dimensions_of(space);
  static constexpr bool plane_stress = space == Space::plane_stress;
  static constexpr bool rings = hoops_of(space) > 0;
  static constexpr bool across = plane_stress || rings;  ///< stretches across the section too

 public:
  explicit EulerianScheme(const SchemeSetup& setup)
      : particles_(setup.particles),
        profile_(setup.profile),
        settings_(setup.settings),
        materials_(setup.particles, setup.materials),
        smoothing_(smoothing_range(setup.particles)),
        neighbourhood_(setup.particles, Kernel::support * smoothing_.second, setup.symmetry,
                       {setup.settings.contact ? Pairing::within_bodies : Pairing::all}),
        anvil_(setup.settings.anvil),
        walls_(walls_of(setup.symmetry, setup.settings.anvil)) {
    if (CorrectedSums<Kernel, D>::needed(settings_)) corrected_.emplace(settings_);
    if (settings_.contact)
      contact_.emplace(particles_, setup.materials, neighbourhood_.support(), setup.symmetry, *settings_.contact);
  }

  void start() override {
    for (const auto field :
         {Field::pressure, Field::sound_speed, Field::wave_speed, Field::viscous_work, Field::acceleration,
          Field::velocity_gradient, Field::viscous_power, Field::viscous_signal, Field::search_position})
      particles_.allocate(field);
    if (!particles_.has(Field::specific_internal_energy)) particles_.allocate(Field::specific_internal_energy);
    if constexpr (across) {
      particles_.allocate(Field::thickness);
      std::ranges::fill(particles_.reals(Field::thickness), 1.0);
    }
    materials_.start();
    allocate_scratch();
    materials_.evaluate_state();
    neighbourhood_.prepare(0.0);
    if (contact_) contact_->start();
    evaluate_rates(0.0);
  }

  void restore(const std::map<std::string, double>& state) override {
    allocate_scratch();
    neighbourhood_.restore(state);
    if (contact_) contact_->restore(state);
  }
  void save(std::map<std::string, double>& state) const override {
    neighbourhood_.save(state);
    if (contact_) contact_->save(state);
  }

  void step(double dt) override {
    search(dt);
    evaluate_rates(dt);
    anvil_.stop(particles_, dt);
    advance(dt);
    anvil_.rest(particles_);
  }

  /// One sweep of pairs a step, and one more for the correction.
  Halos halos(const std::map<std::string, double>& state) const override {
    return halos_of(neighbourhood_, settings_.corrected_eulerian ? 2 : 1, contact_, state);
  }
  bool search_is_due(double dt) override { return any_search_is_due(neighbourhood_, dt, contact_, dt); }
  void begin_search(double dt) override { begin_searches(neighbourhood_, dt, contact_, dt); }

  TimeStep stable_step() const override {
    return smallest_step<D>(least_stable_step<D>(particles_, settings_.courant, coefficients_of(settings_.viscosity)),
                            particles_, walls_, contact_, settings_.courant);
  }

  Ledger ledger() override { return ledger_sums_(particles_, contact_ ? contact_->energy() : 0.0); }

  bool in_contact() const override {
    if (contact_) return contact_->touching();
    return body_contact(neighbourhood_.pairs(), particles_, records_, Kernel::support);
  }

  std::string remark() const override { return remark_on_correction(without_correction()); }

  std::vector<Warning> warnings() const override {
    return few_neighbours(without_correction(), count_of_all(particles_));
  }

  std::size_t memory() const override {
    return neighbourhood_.memory() + (contact_ ? contact_->memory() : 0) +
           records_.capacity() * sizeof(EulerianRecord<D>) + strain_rates_.capacity() * sizeof(StrainRateRecord<D>) +
           (corrected_ ? corrected_->memory() : 0) + rings_.memory();
  }

 private:
  std::size_t without_correction() const { return without_of_all(particles_, corrected_ ? corrected_->without() : 0); }

  void allocate_scratch() {
    particles_.allocate(Field::half_density);
    if constexpr (rings) HalfState<D>::allocate(particles_);
    materials_.allocate_scratch();
    if constexpr (across) particles_.allocate(Field::across_rate);
  }

  void search(double dt) {
    const auto scope = profile_.time("search");
    const bool ordered = neighbourhood_.prepare(dt);
    if (contact_) contact_->prepare(dt, ordered);
  }

  /// Accelerations, velocity gradients and heating in the middle of a step.
  void evaluate_rates(double dt) {
    predict(0.5 * dt);
    const auto scope = profile_.time("pairs");
    if (corrected_)
      corrected_->evaluate(particles_, neighbourhood_.pairs(), neighbourhood_.mirror(), records_, strain_rates_.data());
    else
      with_smoothing(smoothing_, [this](const auto& smoothing) { this->sum_over_pairs(smoothing); });
    auto& p = particles_;
    if constexpr (rings) rings_.turn(p, neighbourhood_.pairs());
    if (contact_)
      contact_->add_forces([this](std::size_t i) { return records_[i].x; }, p.template vectors<D>(Field::acceleration));
    hold_still(p, neighbourhood_.mirror(), p.template vectors<D>(Field::acceleration));
  }

  void predict(double half_step) {
    const auto scope = profile_.time("predict");
    auto& p = particles_;
    neighbourhood_.mirror().fit(records_, p.count());
    if (reconstructs(settings_.viscosity)) neighbourhood_.mirror().fit(strain_rates_, p.count());
    if constexpr (rings) rings_.resize(p, neighbourhood_.mirror());
    materials_.for_each_run([&](const auto& run) {
      if constexpr (plane_stress) {
        if (half_step > 0.0) materials_.stretch_across(run, half_step);
      }
      if constexpr (rings) rings_.predict(p, run.range);
      predict(run, half_step);
    });
    neighbourhood_.mirror().fill(records_, p.count());
    if (reconstructs(settings_.viscosity)) neighbourhood_.mirror().fill(strain_rates_, p.count());
    if constexpr (rings) rings_.fill_images(p, neighbourhood_.mirror());
  }

  using Run = typename MaterialPasses<D, across>::Run;

  /// The records of a run's particles.
  void predict(const Run& run, double half_step) {
    const auto& m = materials_;
    const auto all = m.all_of(run);
    auto* const records = records_.data() + run.range.begin;
    const double* const rate = across ? m.scalars(run, Field::across_rate) : nullptr;
    double* const density = m.scalars(run, Field::half_density);
    const HalfState<D> half(particles_, run.range);
    run_through(
        all, PredictMotion<D, across>{
                 m.vectors(run, Field::position), m.vectors(run, Field::velocity), m.vectors(run, Field::acceleration),
                 half.velocity_gradient, m.symmetrics(run, Field::deviatoric_stress), m.scalars(run, Field::density),
                 m.scalars(run, Field::specific_internal_energy), m.scalars(run, Field::pressure),
                 m.scalars(run, Field::viscous_power), rate, half_step, records, density, half.energy});
    if (reconstructs(settings_.viscosity))
      run_through(all, NoteStrainRates<D>{half.velocity_gradient, strain_rates_.data() + run.range.begin});
    if constexpr (rings) rings_.measure(particles_, run.range, half_step, records_);
    m.evaluate_eos(run, density, half.energy, half.pressure, half.sound_speed);
    m.predict_strength(run, half_step, half.velocity_gradient, half.deviatoric_stress);
    m.release(run, half.deviatoric_stress, half.pressure);
    run_through(
        all, AssembleRecords<D, across>{m.scalars(run, Field::mass), density, half.pressure, half.sound_speed,
                                        half.deviatoric_stress, across ? thickness() + run.range.begin : nullptr, rate,
                                        rings ? 0.0 : half_step, m.scalars(run, Field::smoothing_length), records});
    if constexpr (rings) rings_.show(particles_, run.range, records_);
  }

  template <class Smoothing>
  void sum_over_pairs(const Smoothing& smoothing) {
    auto& p = particles_;
    std::visit(
        [&]<class Chosen>(const Chosen& viscosity) {
          for_each_pair(neighbourhood_.pairs(),
                        EulerianRates<Kernel, Smoothing, Chosen, D>{
                            records_.data(), smoothing, viscosity, p.template vectors<D>(Field::acceleration),
                            p.template tensors<D>(Field::velocity_gradient), p.scalars(Field::viscous_power),
                            p.scalars(Field::viscous_signal), strain_rates_.data()});
        },
        settings_.viscosity);
  }

  /// The whole state at the end of a step.
  void advance(double dt) {
    const auto scope = profile_.time("advance");
    auto& p = particles_;
    materials_.for_each_run([&](const auto& run) {
      if constexpr (plane_stress) {
        materials_.stretch_across(run, dt);
      }
      if constexpr (across) {
        run_through(run.range, AdvanceThickness{p.scalars(Field::across_rate), dt, p.scalars(Field::thickness)});
      }
      run_through(run.range, AdvanceMotion<D, across>{
                                 records_.data(), p.template vectors<D>(Field::acceleration),
                                 p.template tensors<D>(Field::velocity_gradient), p.scalars(Field::viscous_power),
                                 across_rate(), dt, p.template vectors<D>(Field::position),
                                 p.template vectors<D>(Field::velocity), p.scalars(Field::density),
                                 p.scalars(Field::specific_internal_energy), p.scalars(Field::viscous_work)});
      if constexpr (rings) rings_.heat(p, run.range, dt);
      materials_.advance_strength(run, dt);
      materials_.advance_damage(run, dt);
      if constexpr (rings) rings_.pass_through_axis(p, run.range);
      materials_.evaluate_state(run);
    });
  }

  const double* across_rate() { return across ? particles_.scalars(Field::across_rate) : nullptr; }
  /// Of the middle of the step for rings, of its start in plane stress.
  const double* thickness() {
    if constexpr (rings) return rings_.circumference();
    return plane_stress ? particles_.scalars(Field::thickness) : nullptr;
  }

  Particles& particles_;
  Profile& profile_;
  SchemeSettings settings_;
  LedgerSums<D> ledger_sums_;
  MaterialPasses<D, across> materials_;
  std::pair<double, double> smoothing_;  ///< smallest and largest h
  Neighbourhood<D> neighbourhood_;
  std::optional<CorrectedSums<Kernel, D>> corrected_;
  std::optional<KernelContact<D, Kernel>> contact_;
  StopAtAnvil<D> anvil_;
  std::vector<SymmetryPlane> walls_;
  EulerianRings<Kernel> rings_;  ///< of an axisymmetric space
  std::vector<EulerianRecord<D>> records_;
  std::vector<StrainRateRecord<D>> strain_rates_;  ///< of the step before, where the viscosity reads them
};

/// One space for all kernels; each space is instantiated in a translation unit of its own.
template <Space space>
std::unique_ptr<Scheme> make_eulerian_in(const SchemeSetup& setup) {
  return with_kernel(setup.settings.kernel,
                     [&]<class K>(std::type_identity<K>) { return std::make_unique<EulerianScheme<space, K>>(setup); });
}

}  // namespace tektite
