#pragma once
// Contact between the bodies of a scene, for any scheme: finds who is near a particle of another body, adds the forces,
// keeps the energy that is stored in the contact, and says how large a time step it stands. Bodies that touch at the
// start push each other from there on (passes/touching_contact.hpp).

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "boundary/contact_settings.hpp"
#include "boundary/face_contact.hpp"
#include "boundary/touching_bodies.hpp"
#include "neighbours/neighbourhood.hpp"
#include "parallel/for_each.hpp"
#include "parallel/sums.hpp"
#include "passes/contact_pair.hpp"
#include "passes/time_step_limit.hpp"
#include "physics/kernels/kernel.hpp"
#include "physics/material.hpp"

namespace tektite {

template <int D, class Kernel>
class KernelContact {
 public:
  KernelContact(Particles& particles, const std::map<std::string, Material>& materials, double support,
                std::vector<SymmetryPlane> planes, const ContactSettings& settings);

  void start();
  void restore(const std::map<std::string, double>& state);
  void save(std::map<std::string, double>& state) const;

  /// Makes the search good for a step dt; `ordered` where the particles have another order than at the last call.
  void prepare(double dt, bool ordered);
  /// Of distributed particles: what its sweeps reach (Scheme::halos), whether a step of dt needs a search, and its
  /// beginning, which restore() ends.
  Halo halo(const std::map<std::string, double>& state) const;
  bool search_is_due(double dt) { return neighbourhood_.due(dt); }
  void begin_search(double dt) { neighbourhood_.begin(dt); }
  /// To be called when particles have turned Eulerian: pieces of one body then see each other in the sums.
  void note_conversion();

  /// Adds the forces at the places that place(i) gives to the accelerations.
  template <class Place>
  void add_forces(const Place& place, Vector<double, D>* acceleration) {
    set_places(place);
    double* const stiffness = particles_.scalars(Field::contact_stiffness);
    std::fill_n(stiffness, particles_.count(), 0.0);
    evaluate(acceleration, stiffness);
  }

  /// Energy stored in the contact at the present places, J.
  double energy();
  /// The stable step of two particles of the pair's reduced mass: C · 2/ω with ω² = 2k/m.
  typename TimeStepLimit<D>::Least stable_step(double courant) const;
  bool touching() const;
  std::size_t memory() const;

 private:
  void note_volumes();
  void fill();
  std::vector<std::uint32_t> bodies_of_records() const;
  void find_faces();
  void find_touching();
  void sort();
  ContactPotential<Kernel, D> potential() const;

  template <class Place>
  void set_places(const Place& place) {
    const auto& members = neighbourhood_.members();
    for_each(members.size(), [&](std::size_t n) { records_[members[n]].x = place(members[n]); });
    neighbourhood_.mirror().fill(records_, particles_.count());
  }

  /// At the places set. Without accelerations the energy alone.
  void evaluate(Vector<double, D>* acceleration, double* stiffness);
  void evaluate(const TouchingBodies::Turn& turn, Vector<double, D>* acceleration, double* stiffness);

  Particles& particles_;
  ContactSettings settings_;
  Neighbourhood<D> neighbourhood_;
  std::vector<const Material*> materials_;  ///< of each body
  std::vector<Face> faces_;                 ///< of each body
  std::vector<ContactRecord<D>> records_;
  std::vector<double> energy_;
  RepeatedSum<1> energy_sum_;
  TouchingBodies touching_;
  std::size_t sorted_ = 0;  ///< the list that the pairs of bodies in touch are sorted from
  std::vector<ContactSum> sums_;
  std::vector<ContactShare> shares_;
};

// In kernel_contact.cpp, once for all schemes.
extern template class KernelContact<1, CubicSpline>;
extern template class KernelContact<2, CubicSpline>;
extern template class KernelContact<3, CubicSpline>;
extern template class KernelContact<1, WendlandC2>;
extern template class KernelContact<2, WendlandC2>;
extern template class KernelContact<3, WendlandC2>;
extern template class KernelContact<1, TruncatedGaussian>;
extern template class KernelContact<2, TruncatedGaussian>;
extern template class KernelContact<3, TruncatedGaussian>;

}  // namespace tektite
