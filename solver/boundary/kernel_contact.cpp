#include "boundary/kernel_contact.hpp"

#include <cmath>
#include <limits>

#include "neighbours/reference_pairs.hpp"
#include "parallel/for_each_pair.hpp"
#include "parallel/reduce.hpp"
#include "parallel/sums.hpp"
#include "passes/contact_forces.hpp"

namespace tektite {

template <int D, class Kernel>
KernelContact<D, Kernel>::KernelContact(Particles& particles, const std::map<std::string, Material>& materials,
                                        double support, std::vector<SymmetryPlane> planes,
                                        const ContactSettings& settings)
    : particles_(particles),
      settings_(settings),
      neighbourhood_(particles, support, std::move(planes),
                     {settings.itself ? Pairing::all : Pairing::across_bodies, false, Field::contact_search_position,
                      Listed::all, settings.itself, "contact"}),
      touching_([this](std::uint32_t a, std::uint32_t b) {
        return settings_.at_faces
                   ? energy_at_face<Kernel, D>(faces_[a], faces_[b], settings_.factor, settings_.exponent)
                   : 0.0;
      }) {
  for (const auto& body : particles.bodies()) materials_.push_back(&materials.at(body.material));
  find_faces();
}

template <int D, class Kernel>
void KernelContact<D, Kernel>::start() {
  particles_.allocate(Field::contact_search_position);
  particles_.allocate(Field::contact_stiffness);
  if (!particles_.has(Field::reference_volume)) note_volumes();
  neighbourhood_.renew(0.0);
  fill();
  find_touching();
}

template <int D, class Kernel>
void KernelContact<D, Kernel>::restore(const std::map<std::string, double>& state) {
  neighbourhood_.restore(state);
  touching_.restore(state, static_cast<std::uint32_t>(particles_.bodies().size()));
  fill();
  sort();
}

template <int D, class Kernel>
void KernelContact<D, Kernel>::save(std::map<std::string, double>& state) const {
  neighbourhood_.save(state);
  touching_.save(state);
}

template <int D, class Kernel>
void KernelContact<D, Kernel>::prepare(double dt, bool ordered) {
  if (ordered) {
    neighbourhood_.renew(dt);
    fill();
  } else {
    neighbourhood_.prepare(dt);
    neighbourhood_.mirror().fit(records_, particles_.count());
  }
  if (sorted_ != neighbourhood_.lists()) sort();
}

/// Of bodies in touch a force reads the sums of both, which reach as far again.
template <int D, class Kernel>
Halo KernelContact<D, Kernel>::halo(const std::map<std::string, double>& state) const {
  return neighbourhood_.halo(state, settings_.at_faces || TouchingBodies::any_in(state) ? 2 : 1);
}

template <int D, class Kernel>
void KernelContact<D, Kernel>::note_conversion() {
  if (!settings_.itself) return;
  neighbourhood_.list();
  sort();
}

template <int D, class Kernel>
double KernelContact<D, Kernel>::energy() {
  const auto* x = particles_.template vectors<D>(Field::position);
  set_places([x](std::size_t i) { return x[i]; });
  evaluate(nullptr, nullptr);
  return energy_sum_(particles_, [this](std::size_t i) { return std::array{energy_[i]}; })[0];
}

template <int D, class Kernel>
typename TimeStepLimit<D>::Least KernelContact<D, Kernel>::stable_step(double courant) const {
  const auto* id = particles_.integers(Field::id).data();
  const double* mass = particles_.scalars(Field::mass);
  const double* stiffness = particles_.scalars(Field::contact_stiffness);
  const auto limit = [&](typename TimeStepLimit<D>::Least& least, std::size_t i) {
    const double dt = courant * std::sqrt(limit_of(2.0 * mass[i], stiffness[i]));
    if (dt <= least.dt) TimeStepLimit<D>::join(least, {dt, id[i], StepLimit::contact});
  };
  return reduce(particles_, typename TimeStepLimit<D>::Least{}, limit, TimeStepLimit<D>::join);
}

template <int D, class Kernel>
bool KernelContact<D, Kernel>::touching() const {
  const bool any = std::any_of(energy_.begin(), energy_.end(), [](double energy) { return energy > 0.0; });
  return over_ranks(particles_, any, either);
}

template <int D, class Kernel>
std::size_t KernelContact<D, Kernel>::memory() const {
  return neighbourhood_.memory() + records_.capacity() * sizeof(ContactRecord<D>) +
         energy_.capacity() * sizeof(double) + touching_.memory() + sums_.capacity() * sizeof(ContactSum) +
         shares_.capacity() * sizeof(ContactShare);
}

/// Those at the start, whatever density a region has there.
template <int D, class Kernel>
void KernelContact<D, Kernel>::note_volumes() {
  particles_.allocate(Field::reference_volume);
  const double *mass = particles_.scalars(Field::mass), *density = particles_.scalars(Field::density);
  double* const volume = particles_.scalars(Field::reference_volume);
  for_each(particles_.count(), [=](std::size_t i) { volume[i] = mass[i] / density[i]; });
}

/// What does not change from step to step.
template <int D, class Kernel>
void KernelContact<D, Kernel>::fill() {
  neighbourhood_.mirror().fit(records_, particles_.count());
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

template <int D, class Kernel>
std::vector<std::uint32_t> KernelContact<D, Kernel>::bodies_of_records() const {
  auto body = body_of_each(particles_);
  neighbourhood_.mirror().repeat(body);
  return body;
}

template <int D, class Kernel>
void KernelContact<D, Kernel>::find_faces() {
  std::vector<double> most;  // of h
  const auto larger = [](double& whole, double part) { whole = std::max(whole, part); };
  for (const auto& body : particles_.bodies()) {
    most.push_back(0.0);
    for (const double h : particles_.reals(Field::smoothing_length).subspan(body.range.begin, body.range.size()))
      larger(most.back(), h);
  }
  each_over_ranks(particles_, most, larger);
  for (std::size_t k = 0; k < most.size(); ++k)
    faces_.push_back({bulk_modulus_of(*materials_[k]), most[k], particles_.bodies()[k].spacing});
}

template <int D, class Kernel>
void KernelContact<D, Kernel>::find_touching() {
  const auto* x = particles_.template vectors<D>(Field::position);
  set_places([x](std::size_t i) { return x[i]; });
  touching_.find(particles_, neighbourhood_.pairs(), bodies_of_records(),
                 [this](const PairList& pairs, std::vector<ContactSum>& sums) {
                   for_each_pair(pairs, ContactSums<Kernel, D>{potential(), sums.data()});
                 });
  sort();
}

template <int D, class Kernel>
void KernelContact<D, Kernel>::sort() {
  touching_.sort(particles_, neighbourhood_.pairs(), bodies_of_records());
  sorted_ = neighbourhood_.lists();
}

template <int D, class Kernel>
ContactPotential<Kernel, D> KernelContact<D, Kernel>::potential() const {
  return {records_.data(), settings_.factor, settings_.exponent};
}

template <int D, class Kernel>
void KernelContact<D, Kernel>::evaluate(Vector<double, D>* acceleration, double* stiffness) {
  std::ranges::fill(energy_, 0.0);
  for_each_pair(touching_.apart(), ContactForces<Kernel, D>{potential(), particles_.scalars(Field::mass), acceleration,
                                                            stiffness, energy_.data()});
  for (const auto& turn : touching_.turns()) evaluate(turn, acceleration, stiffness);
}

template <int D, class Kernel>
void KernelContact<D, Kernel>::evaluate(const TouchingBodies::Turn& turn, Vector<double, D>* acceleration,
                                        double* stiffness) {
  sums_.assign(particles_.count(), {});
  neighbourhood_.mirror().fit(shares_, particles_.count());
  for_each_pair(turn.pairs, ContactSums<Kernel, D>{potential(), sums_.data()});
  const double* volume = particles_.scalars(Field::reference_volume);
  for (std::size_t k = 0; k < turn.at_start.size(); ++k) {
    const auto members = members_in(particles_.bodies()[k].range, neighbourhood_.members());
    for_each(members.size(), [&](std::size_t n) {
      const auto i = members[n];
      const double at_start = turn.at_start[k] * volume[i];
      energy_[i] += energy_since_start(sums_[i].energy, at_start);
      shares_[i] = share_of(sums_[i], at_start);
    });
  }
  if (!acceleration) return;
  neighbourhood_.mirror().fill(shares_, particles_.count());
  for_each_pair(turn.pairs, TouchingForces<Kernel, D>{potential(), shares_.data(), particles_.scalars(Field::mass),
                                                      acceleration, stiffness});
}

template class KernelContact<1, CubicSpline>;
template class KernelContact<2, CubicSpline>;
template class KernelContact<3, CubicSpline>;
template class KernelContact<1, WendlandC2>;
template class KernelContact<2, WendlandC2>;
template class KernelContact<3, WendlandC2>;
template class KernelContact<1, TruncatedGaussian>;
template class KernelContact<2, TruncatedGaussian>;
template class KernelContact<3, TruncatedGaussian>;

}  // namespace tektite
