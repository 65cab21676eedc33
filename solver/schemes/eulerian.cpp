#include "schemes/eulerian.hpp"

namespace tektite {

// Each space in a translation unit of its own: eulerian_line.cpp and so on.
template <Space space>
std::unique_ptr<Scheme> make_eulerian_in(const SchemeSetup& setup);

std::unique_ptr<Scheme> make_eulerian(const SchemeSetup& setup) {
  switch (setup.particles.space()) {
    case Space::line:
      return make_eulerian_in<Space::line>(setup);
    case Space::plane_strain:
      return make_eulerian_in<Space::plane_strain>(setup);
    case Space::plane_stress:
      return make_eulerian_in<Space::plane_stress>(setup);
    case Space::solid:
      return make_eulerian_in<Space::solid>(setup);
    case Space::cylindrical:
    case Space::spherical:
    case Space::axisymmetric:
      break;
  }
  throw InputError({{},
                    "space",
                    std::string(name_of(setup.particles.space())),
                    "the scheme eulerian does not support it",
                    "line, plane-strain, plane-stress, solid"});
}

}  // namespace tektite
