#include "schemes/eulerian.hpp"

#include "schemes/make_scheme_in.hpp"

namespace tektite {

// Each space in a translation unit of its own: eulerian_line.cpp and so on.
template <Space space>
std::unique_ptr<Scheme> make_eulerian_in(const SchemeSetup& setup);

std::unique_ptr<Scheme> make_eulerian(const SchemeSetup& setup) {
  if (setup.settings.contact && hoops_of(setup.particles.space()) > 0)
    throw InputError({{}, "contact", {}, "the potential of the contact does not count rings", "no [contact]"});
  return in_space<Space::line, Space::plane_strain, Space::plane_stress, Space::axisymmetric, Space::solid>(
      setup, [&](auto space) { return make_eulerian_in<space()>(setup); });
}

}  // namespace tektite
