#include "schemes/godunov_pm.hpp"

namespace tektite {

std::unique_ptr<Scheme> make_godunov_pm(const SchemeSetup& setup) {
  switch (setup.particles.space()) {
    case Space::line:
      return make_godunov_pm_line(setup);
    case Space::plane_strain:
      return make_godunov_pm_plane_strain(setup);
    case Space::solid:
      return make_godunov_pm_solid(setup);
    case Space::plane_stress:
    case Space::cylindrical:
    case Space::spherical:
    case Space::axisymmetric:
      break;
  }
  throw InputError({{},
                    "space",
                    std::string(name_of(setup.particles.space())),
                    "the scheme godunov-pm does not support it",
                    "line, plane-strain, solid"});
}

}  // namespace tektite
