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
#include "passes/hold_clamped.hpp"
#include "passes/smoothing.hpp"
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
        smoothing_(smallest_and_largest(setup.particles)),
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
    evaluate_state();
    neighbourhood_.prepare(0.0);
    if (contact_) contact_->start();
    step(0.0);  // nothing moves: speeds of approach for the first time step
  }

  void restore(const std::map<std::string, double>& state) override {
    allocate_scratch();
    neighbourhood_.restore(state.at("search_reach"), static_cast<int>(state.at("searches_since_order")));
    if (contact_) contact_->restore(state);
    resize_records();
    place_records();
  }
  void save(std::map<std::string, double>& state) const override {
    state["search_reach"] = neighbourhood_.reach();
    state["searches_since_order"] = neighbourhood_.searches_since_order();
    if (contact_) contact_->save(state);
  }

  TimeStep stable_step() const override {
    const auto least = least_acoustic_step<D>(particles_, settings_.courant);
    const auto contact = contact_ ? contact_->stable_step(settings_.courant) : least;
    const auto& choice = contact.dt < least.dt ? contact : least;
    return {choice.dt, choice.reason, choice.particle};
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

  /// sweep(smoothing) with what gives a pair's smoothing length.
  template <class Sweep>
  void with_smoothing(const Sweep& sweep) const {
    if (smoothing_.first == smoothing_.second)
      sweep(UniformSmoothing(smoothing_.first));
    else
      sweep(MeanSmoothing(smoothing_.first));
  }

  /// Clamped particles and those on a symmetry plane stay where they have to.
  void hold(Vector<double, D>* acceleration) {
    if (particles_.has(Field::clamped))
      run_through({0, particles_.count()}, HoldClamped<D>{particles_.integers(Field::clamped).data(), acceleration});
    neighbourhood_.mirror().hold(acceleration);
  }

  /// Pressure and wave speeds of the present state.
  void evaluate_state() {
    materials_.for_each_run([&](const Run& run) { evaluate_state(run); });
  }
  void evaluate_state(const Run& run) const {
    materials_.evaluate_eos(run, Field::density, Field::specific_internal_energy, Field::pressure, Field::sound_speed);
    materials_.release(run, Field::deviatoric_stress, Field::pressure);
    materials_.evaluate_wave_speed(run);
  }

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

 private:
  static std::pair<double, double> smallest_and_largest(const Particles& particles) {
    const auto h = particles.reals(Field::smoothing_length);
    const auto [least, most] = std::minmax_element(h.begin(), h.end());
    return {*least, *most};
  }
};

/// The scheme in one space for the kernel that the scene asks for.
template <template <Space, class> class SchemeOf, Space space>
std::unique_ptr<Scheme> make_with_kernel(const SchemeSetup& setup) {
  std::unique_ptr<Scheme> scheme;
  const auto attempt = [&]<class K>(std::type_identity<K>) {
    if (K::name == setup.settings.kernel) scheme = std::make_unique<SchemeOf<space, K>>(setup);
  };
  attempt(std::type_identity<CubicSpline>{});
  attempt(std::type_identity<WendlandC2>{});
  attempt(std::type_identity<TruncatedGaussian>{});
  return scheme;
}

}  // namespace tektite
