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
      break;
  }
  throw InputError(
      {{}, "space", "plane-stress", "the scheme godunov-split does not support it", "line, plane-strain, solid"});
}

}  // namespace tektite
