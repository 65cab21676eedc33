#pragma once
// What the Godunov schemes have in common: they know everything at whole steps, sum over neighbours in the places of
// the start of a step, and have no viscosity.

#include <algorithm>
#include <optional>

#include "boundary/kernel_contact.hpp"
#include "neighbours/neighbourhood.hpp"
#include "parallel/for_each_pair.hpp"
#include "passes/body_contact.hpp"
#include "passes/godunov_motion.hpp"
#include "passes/smoothing.hpp"
#include "schemes/hold_still.hpp"
#include "schemes/make_scheme_in.hpp"
#include "schemes/material_passes.hpp"
#include "schemes/scheme.hpp"
#include "schemes/searches.hpp"
#include "schemes/state_sums.hpp"

namespace tektite {

/// `Record` is what a pair sees of a particle in the last of the sweeps.
template <Space space, class Kernel, class Record>
class GodunovScheme : public Scheme {
 protected:
  static constexpr int D = dimensions_of(space);
  static constexpr bool plane_stress = space == Space::plane_stress;
  using Materials = MaterialPasses<D, plane_stress>;
  using Run = typename Materials::Run;

 public:
  explicit GodunovScheme(const SchemeSetup& setup)
      : particles_(setup.particles),
        profile_(setup.profile),
        settings_(setup.settings),
        materials_(setup.particles, setup.materials),
        smoothing_(smoothing_range(setup.particles)),
        neighbourhood_(setup.particles, Kernel::support * smoothing_.second, setup.symmetry,
                       {setup.settings.contact ? Pairing::within_bodies : Pairing::all}) {
    if (settings_.contact)
      contact_.emplace(particles_, setup.materials, neighbourhood_.support(), setup.symmetry, *settings_.contact);
  }

  void start() override {
    for (const auto field : {Field::pressure, Field::sound_speed, Field::wave_speed, Field::acceleration,
                             Field::velocity_gradient, Field::approach_speed, Field::search_position})
      particles_.allocate(field);
    if (!particles_.has(Field::specific_internal_energy)) particles_.allocate(Field::specific_internal_energy);
    if constexpr (plane_stress) {
      for (const auto field : {Field::thickness, Field::viscous_power}) particles_.allocate(field);
      std::ranges::fill(particles_.reals(Field::thickness), 1.0);
    }
    materials_.start();
    allocate_scratch();
    materials_.evaluate_state();
    neighbourhood_.prepare(0.0);
    if (contact_) contact_->start();
    step(0.0);  // nothing moves: speeds of approach for the first time step
  }

  void restore(const std::map<std::string, double>& state) override {
    allocate_scratch();
    neighbourhood_.restore(state);
    if (contact_) contact_->restore(state);
    resize_records();
    place_records();
  }
  void save(std::map<std::string, double>& state) const override {
    neighbourhood_.save(state);
    if (contact_) contact_->save(state);
  }

  bool search_is_due(double dt) override { return any_search_is_due(neighbourhood_, 0.0, contact_, contact_step(dt)); }
  void begin_search(double dt) override { begin_searches(neighbourhood_, 0.0, contact_, contact_step(dt)); }

  TimeStep stable_step() const override {
    const auto motion = [approach = particles_.scalars(Field::approach_speed)](std::size_t i) { return approach[i]; };
    return smallest_step<D>(least_acoustic_step<D>(particles_, settings_.courant, motion), particles_,
                            neighbourhood_.mirror().planes(), contact_, settings_.courant);
  }

  Ledger ledger() override { return ledger_sums_(particles_, contact_ ? contact_->energy() : 0.0); }

  bool in_contact() const override {
    if (contact_) return contact_->touching();
    return body_contact(neighbourhood_.pairs(), particles_, records_, Kernel::support);
  }

  std::size_t memory() const override {
    return neighbourhood_.memory() + (contact_ ? contact_->memory() : 0) + records_.capacity() * sizeof(Record) +
           (power_.capacity() + divergence_.capacity()) * sizeof(double) +
           (contact_acceleration_.capacity() + deviatoric_acceleration_.capacity()) * sizeof(Vector<double, D>);
  }

 protected:
  virtual void resize_records() {
    neighbourhood_.mirror().fit(records_, particles_.count());
    power_.resize(particles_.count());
    divergence_.resize(particles_.count());
    if (contact_) contact_acceleration_.resize(particles_.count());
    if (contact_ && settings_.corrected_eulerian) deviatoric_acceleration_.resize(particles_.count());
  }

  void allocate_scratch() {
    for (const auto field : {Field::half_pressure, Field::half_sound_speed}) particles_.allocate(field);
    if constexpr (plane_stress) {
      for (const auto field : {Field::across_rate, Field::half_density}) particles_.allocate(field);
    }
    materials_.allocate_scratch();
  }

  /// Velocity, place, energy, density and, in plane stress, the thickness at the end of the step. With corrected
  /// gradients the place moves with the velocity that strains, so that distances and densities agree where the two
  /// halves of a split step accelerate against each other, as they do at every surface.
  void advance_motion(const Run& run, double dt) {
    auto& p = particles_;
    if constexpr (plane_stress) {
      if (dt > 0.0) stretch_across(run, dt);
    }
    run_through(run.range,
                AdvanceGodunov<D>{heat(dt), centring(), p.template vectors<D>(Field::position),
                                  p.template vectors<D>(Field::velocity), p.scalars(Field::specific_internal_energy)});
    run_through(run.range,
                AdvanceDensity<plane_stress>{divergence_.data(), across_rate(), dt, p.scalars(Field::density)});
  }

  void stretch_across(const Run& run, double dt) requires plane_stress {
    auto& p = particles_;
    run_through(run.range, GrowArea{heat(dt), divergence_.data(), p.template symmetrics<D>(Field::deviatoric_stress),
                                    p.scalars(Field::pressure), p.scalars(Field::density),
                                    p.template tensors<D>(Field::velocity_gradient), p.scalars(Field::viscous_power)});
    materials_.stretch_across(run, dt);
    run_through(run.range, AdvanceThickness{p.scalars(Field::across_rate), dt, p.scalars(Field::thickness)});
  }

  const double* across_rate() const { return plane_stress ? particles_.scalars(Field::across_rate) : nullptr; }
  GodunovHeat<D> heat(double dt) const {
    return {particles_.template vectors<D>(Field::acceleration), contact_ ? contact_acceleration_.data() : nullptr,
            deviatoric_acceleration_.empty() ? nullptr : deviatoric_acceleration_.data(), power_.data(), dt};
  }
  const double* thickness() const { return plane_stress ? particles_.scalars(Field::thickness) : nullptr; }

  /// Brings the places in the records up to date: that is what tells of contact.
  void place_records() {
    for_each(particles_.count(), [this](std::size_t i) {
      records_[i].x = particles_.template vectors<D>(Field::position)[i];
      records_[i].smoothing_length = particles_.scalars(Field::smoothing_length)[i];
    });
    neighbourhood_.mirror().fill(records_, particles_.count());
  }

  /// Makes the lists good for the present places and a step dt.
  void search(double dt) {
    const auto scope = profile_.time("search");
    const bool ordered = neighbourhood_.prepare(0.0);
    if (contact_) contact_->prepare(contact_step(dt), ordered);
    resize_records();
  }

  /// The force between bodies, which acts together with the pairs' stresses: those and a kick of its own would take
  /// turns at what they hold in balance, and the pairs be strained by a velocity that is taken back within the step. It
  /// is that of the places that make the motion by it alone a leapfrog.
  void find_contact(double dt) {
    if (!contact_) return;
    const auto scope = profile_.time("contact");
    std::ranges::fill(contact_acceleration_, Vector<double, D>::zero());
    const auto ahead = [x = particles_.template vectors<D>(Field::position),
                        v = particles_.template vectors<D>(Field::velocity),
                        part = (1.0 - centring()) * dt](std::size_t i) { return x[i] + part * v[i]; };
    contact_->add_forces(ahead, contact_acceleration_.data());
    hold(contact_acceleration_.data());
  }

  /// The share c of a step's change of velocity in that by which the place moves.
  double centring() const { return settings_.corrected_eulerian ? 0.0 : 0.5; }

  /// The step in whose middle the contact is looked for.
  double contact_step(double dt) const { return 2.0 * (1.0 - centring()) * dt; }

  void hold(Vector<double, D>* acceleration) { hold_still(particles_, neighbourhood_.mirror(), acceleration); }

  const double* damage() const { return particles_.has(Field::damage) ? particles_.scalars(Field::damage) : nullptr; }

  Particles& particles_;
  Profile& profile_;
  SchemeSettings settings_;
  LedgerSums<D> ledger_sums_;
  Materials materials_;
  std::pair<double, double> smoothing_;  ///< smallest and largest h
  Neighbourhood<D> neighbourhood_;
  std::optional<KernelContact<D, Kernel>> contact_;
  std::vector<Record> records_;
  std::vector<double> power_;                               ///< W/kg
  std::vector<double> divergence_;                          ///< of the velocities at the contacts, 1/s
  std::vector<Vector<double, D>> contact_acceleration_;     ///< by the force between bodies; empty without [contact]
  std::vector<Vector<double, D>> deviatoric_acceleration_;  ///< of this step, where contacts heat by it; else empty
};

}  // namespace tektite
