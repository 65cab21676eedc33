#pragma once
// The searches of a scheme whose particles are distributed, as search() of the scheme makes them elsewhere: the one for
// its sums, which may order the particles, and that of the contact, which follows any new order.

#include <optional>

#include "boundary/kernel_contact.hpp"
#include "neighbours/neighbourhood.hpp"

namespace tektite {

/// Whether a step of dt needs either; `contact_dt` is what the contact looks ahead by.
template <int D, class Kernel>
bool any_search_is_due(Neighbourhood<D>& neighbourhood, double dt, std::optional<KernelContact<D, Kernel>>& contact,
                       double contact_dt) {
  return neighbourhood.due(dt) || (contact && contact->search_is_due(contact_dt));
}

/// Begins those that are due.
template <int D, class Kernel>
void begin_searches(Neighbourhood<D>& neighbourhood, double dt, std::optional<KernelContact<D, Kernel>>& contact,
                    double contact_dt) {
  const bool ordered = neighbourhood.due(dt) && neighbourhood.begin(dt);
  if (contact && (ordered || contact->search_is_due(contact_dt))) contact->begin_search(contact_dt);
}

/// What so many sweeps of the scheme and those of the contact reach.
template <int D, class Kernel>
Halos halos_of(const Neighbourhood<D>& neighbourhood, int sweeps,
               const std::optional<KernelContact<D, Kernel>>& contact, const std::map<std::string, double>& state) {
  Halos halos{neighbourhood.halo(state, sweeps)};
  if (contact) halos.push_back(contact->halo(state));
  return halos;
}

}  // namespace tektite
