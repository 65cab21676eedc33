#include "schemes/total_lagrangian.hpp"

namespace tektite {

// Each space in a translation unit of its own: total_lagrangian_line.cpp and so on.
template <Space space>
std::unique_ptr<Scheme> make_total_lagrangian_in(const SchemeSetup& setup);

std::unique_ptr<Scheme> make_total_lagrangian(const SchemeSetup& setup) {
  if (setup.particles.bodies().size() > 1 && !setup.settings.contact)
    throw InputError({{},
                      "contact",
                      {},
                      setup.settings.type + " bodies meet by contact alone, and the scene has none",
                      "[contact]"});
  switch (setup.particles.space()) {
    case Space::line:
      return make_total_lagrangian_in<Space::line>(setup);
    case Space::plane_strain:
      return make_total_lagrangian_in<Space::plane_strain>(setup);
    case Space::solid:
      return make_total_lagrangian_in<Space::solid>(setup);
    case Space::plane_stress:
      break;
  }
  throw InputError({{},
                    "space",
                    "plane-stress",
                    "the scheme " + setup.settings.type + " does not support it",
                    "line, plane-strain, solid"});
}

}  // namespace tektite
