#include "schemes/godunov_split.hpp"

namespace tektite {

std::unique_ptr<Scheme> make_godunov_split(const SchemeSetup& setup) {
  switch (setup.particles.space()) {
    case Space::line:
      return make_godunov_split_line(setup);
    case Space::plane_strain:
      return make_godunov_split_plane_strain(setup);
    case Space::solid:
      return make_godunov_split_solid(setup);
    case Space::plane_stress:
    case Space::cylindrical:
    case Space::spherical:
    case Space::axisymmetric:
      break;
  }
  throw InputError({{},
                    "space",
                    std::string(name_of(setup.particles.space())),
                    "the scheme godunov-split does not support it",
                    "line, plane-strain, solid"});
}

}  // namespace tektite
