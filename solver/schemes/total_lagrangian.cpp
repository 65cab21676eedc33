#include "schemes/total_lagrangian.hpp"

#include "schemes/make_scheme_in.hpp"

namespace tektite {

// Each space in a translation unit of its own: total_lagrangian_line.cpp and so on.
template <Space space>
std::unique_ptr<Scheme> make_total_lagrangian_in(const SchemeSetup& setup);

std::unique_ptr<Scheme> make_total_lagrangian(const SchemeSetup& setup) {
  const bool rings = hoops_of(setup.particles.space()) > 0, several = setup.particles.bodies().size() > 1;
  if (several && !setup.settings.contact)
    throw InputError({{},
                      "contact",
                      {},
                      setup.settings.type + " bodies meet by contact alone, and " +
                          (rings ? "rings know none" : "the scene has none"),
                      rings ? "the scheme eulerian, or a single body" : "[contact]"});
  const auto make = [&](auto space) { return make_total_lagrangian_in<space()>(setup); };
  if (setup.settings.type == "adaptle") return in_space<Space::line, Space::plane_strain, Space::solid>(setup, make);
  if (setup.settings.contact && rings)
    throw InputError({{}, "contact", {}, "the potential of the contact does not count rings", "no [contact]"});
  return in_space<Space::line, Space::plane_strain, Space::axisymmetric, Space::solid>(setup, make);
}

}  // namespace tektite
