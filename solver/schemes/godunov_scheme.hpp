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
#include "schemes/state_sums.hpp"

namespace tektite {

/// `Record` is what a pair sees of a particle in the last of the sweeps.
template <Space space, class Kernel, class Record>
class GodunovScheme : public Scheme {
 protected:
  static constexpr int D = dimensions_of(space);
  using Materials = MaterialPasses<D, false>;
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

  TimeStep stable_step() const override {
    const auto motion = [approach = particles_.scalars(Field::approach_speed)](std::size_t i) { return approach[i]; };
    return with_contact(least_acoustic_step<D>(particles_, settings_.courant, motion), contact_, settings_.courant);
  }

  Ledger ledger() override { return ledger_of<D>(particles_, contact_ ? contact_->energy() : 0.0); }

  bool in_contact() const override {
    if (contact_) return contact_->touching();
    return body_contact(neighbourhood_.pairs(), particles_.bodies(), records_, Kernel::support);
  }

  std::size_t memory() const override {
    return neighbourhood_.memory() + (contact_ ? contact_->memory() : 0) + records_.capacity() * sizeof(Record) +
           (power_.capacity() + divergence_.capacity()) * sizeof(double);
  }

 protected:
  virtual void resize_records() {
    records_.resize(particles_.count() + neighbourhood_.mirror().images());
    power_.resize(particles_.count());
    divergence_.resize(particles_.count());
  }

  void allocate_scratch() {
    for (const auto field : {Field::half_pressure, Field::half_sound_speed}) particles_.allocate(field);
    materials_.allocate_scratch();
  }

  /// Brings the places in the records up to date: that is what tells of contact.
  void place_records() {
    for_each(particles_.count(), [this](std::size_t i) {
      records_[i].x = particles_.template vectors<D>(Field::position)[i];
      records_[i].smoothing_length = particles_.scalars(Field::smoothing_length)[i];
    });
    neighbourhood_.mirror().fill(records_, particles_.count());
  }

  /// Makes the list good for the present places.
  void search() {
    const auto scope = profile_.time("search");
    const bool ordered = neighbourhood_.prepare(0.0);
    if (contact_) contact_->prepare(0.0, ordered);
    resize_records();
  }

  /// The force between bodies changes the velocities; what it stores or gives back stands in the ledger.
  void kick_by_contact(double dt) {
    if (!contact_) return;
    auto& p = particles_;
    auto* const acceleration = p.template vectors<D>(Field::acceleration);
    std::ranges::fill(p.reals(Field::acceleration), 0.0);
    contact_->add_forces([x = p.template vectors<D>(Field::position)](std::size_t i) { return x[i]; }, acceleration);
    hold(acceleration);
    for_each(p.count(),
             [=, v = p.template vectors<D>(Field::velocity)](std::size_t i) { v[i] += dt * acceleration[i]; });
  }

  void hold(Vector<double, D>* acceleration) { hold_still(particles_, neighbourhood_.mirror(), acceleration); }

  const double* damage() const { return particles_.has(Field::damage) ? particles_.scalars(Field::damage) : nullptr; }

  Particles& particles_;
  Profile& profile_;
  SchemeSettings settings_;
  Materials materials_;
  std::pair<double, double> smoothing_;  ///< smallest and largest h
  Neighbourhood<D> neighbourhood_;
  std::optional<KernelContact<D, Kernel>> contact_;
  std::vector<Record> records_;
  std::vector<double> power_;       ///< W/kg
  std::vector<double> divergence_;  ///< of the velocities at the contacts, 1/s
};

}  // namespace tektite
