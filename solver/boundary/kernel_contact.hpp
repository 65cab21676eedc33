#pragma once
// Contact between the bodies of a scene, for any scheme: finds who is near a particle of another body, adds the forces,
// keeps the energy that is stored in the contact, and says how large a time step it stands.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "boundary/contact_settings.hpp"
#include "neighbours/neighbourhood.hpp"
#include "parallel/for_each_pair.hpp"
#include "parallel/reduce.hpp"
#include "passes/contact_forces.hpp"
#include "passes/time_step_limit.hpp"
#include "physics/material.hpp"

namespace tektite {

template <int D, class Kernel>
class KernelContact {
 public:
  KernelContact(Particles& particles, const std::map<std::string, Material>& materials, double support,
                std::vector<SymmetryPlane> planes, const ContactSettings& settings)
      : particles_(particles),
        settings_(settings),
        neighbourhood_(particles, support, std::move(planes),
                       {settings.itself ? Pairing::all : Pairing::across_bodies, false, Field::contact_search_position,
                        Listed::all, settings.itself, "contact"}) {
    for (const auto& body : particles.bodies()) materials_.push_back(&materials.at(body.material));
  }

  void start() {
    particles_.allocate(Field::contact_search_position);
    particles_.allocate(Field::contact_stiffness);
    if (!particles_.has(Field::reference_volume)) note_volumes();
    neighbourhood_.renew(0.0);
    fill();
  }
  void restore(const std::map<std::string, double>& state) {
    neighbourhood_.restore(state);
    fill();
  }
  void save(std::map<std::string, double>& state) const { neighbourhood_.save(state); }

  /// Makes the search good for a step dt; `ordered` where the particles have another order than at the last call.
  void prepare(double dt, bool ordered) {
    if (ordered) {
      neighbourhood_.renew(dt);
      fill();
    } else {
      neighbourhood_.prepare(dt);
      records_.resize(particles_.count() + neighbourhood_.mirror().images());
    }
  }

  /// To be called when particles have turned Eulerian: pieces of one body then see each other in the sums.
  void note_conversion() {
    if (settings_.itself) neighbourhood_.list();
  }

  /// Adds the forces at the places that place(i) gives to the accelerations.
  template <class Place>
  void add_forces(const Place& place, Vector<double, D>* acceleration) {
    double* const stiffness = particles_.scalars(Field::contact_stiffness);
    std::fill_n(stiffness, particles_.count(), 0.0);
    evaluate(place, acceleration, stiffness);
  }

  /// Energy stored in the contact at the present places, J.
  double energy() {
    const auto* x = particles_.template vectors<D>(Field::position);
    evaluate([x](std::size_t i) { return x[i]; }, nullptr, nullptr);
    return reduce(
        energy_.size(), 0.0, [this](double& sum, std::size_t i) { sum += energy_[i]; },
        [](double& whole, double part) { whole += part; });
  }

  /// The stable step of two particles of the pair's reduced mass: C · 2/ω with ω² = 2k/m.
  typename TimeStepLimit<D>::Least stable_step(double courant) const {
    const double* mass = particles_.scalars(Field::mass);
    const double* stiffness = particles_.scalars(Field::contact_stiffness);
    const auto limit = [&](typename TimeStepLimit<D>::Least& least, std::size_t i) {
      const double dt = courant * std::sqrt(limit_of(2.0 * mass[i], stiffness[i]));
      if (dt < least.dt) least = {dt, i, StepLimit::contact};
    };
    return reduce(particles_.count(), typename TimeStepLimit<D>::Least{std::numeric_limits<double>::infinity()}, limit,
                  TimeStepLimit<D>::join);
  }

  bool touching() const {
    return std::any_of(energy_.begin(), energy_.end(), [](double energy) { return energy > 0.0; });
  }

  std::size_t memory() const {
    return neighbourhood_.memory() + records_.capacity() * sizeof(ContactRecord<D>) +
           energy_.capacity() * sizeof(double);
  }

 private:
  /// Those at the start, whatever density a region has there.
  void note_volumes() {
    particles_.allocate(Field::reference_volume);
    const double *mass = particles_.scalars(Field::mass), *density = particles_.scalars(Field::density);
    double* const volume = particles_.scalars(Field::reference_volume);
    for_each(particles_.count(), [=](std::size_t i) { volume[i] = mass[i] / density[i]; });
  }

  /// What does not change from step to step.
  void fill() {
    records_.resize(particles_.count() + neighbourhood_.mirror().images());
    energy_.resize(particles_.count());
    const double* volume = particles_.scalars(Field::reference_volume);
    const double* h = particles_.scalars(Field::smoothing_length);
    for (std::size_t k = 0; k < materials_.size(); ++k) {
      const auto& body = particles_.bodies()[k];
      const double bulk_modulus = bulk_modulus_of(*materials_[k]);
      for (std::size_t i = body.range.begin; i < body.range.end; ++i)
        records_[i] = {Vector<double, D>::zero(), volume[i], bulk_modulus, h[i], body.spacing};
    }
  }

  template <class Place>
  void evaluate(const Place& place, Vector<double, D>* acceleration, double* stiffness) {
    const auto& members = neighbourhood_.members();
    for_each(members.size(), [&](std::size_t n) { records_[members[n]].x = place(members[n]); });
    std::ranges::fill(energy_, 0.0);
    neighbourhood_.mirror().fill(records_, particles_.count());
    for_each_pair(neighbourhood_.pairs(),
                  ContactForces<Kernel, D>{records_.data(), settings_.factor, settings_.exponent,
                                           particles_.scalars(Field::mass), acceleration, stiffness, energy_.data()});
  }

  Particles& particles_;
  ContactSettings settings_;
  Neighbourhood<D> neighbourhood_;
  std::vector<const Material*> materials_;  ///< of each body
  std::vector<ContactRecord<D>> records_;
  std::vector<double> energy_;
};

}  // namespace tektite
